// SPDX-License-Identifier: Apache-2.0
// Which part of the plane a canvas shows. The plane has y up, the canvas y down.
'use strict';

class Camera {
  constructor() {
    this.width = this.height = 1;  // of the canvas, in CSS pixels
    this.x = this.y = 0;           // of the plane, in the middle
    this.scale = 1;                // pixels to a unit
  }

  /** Shows a box [left, bottom, right, top] with `part` of the canvas filled by it. */
  show([left, bottom, right, top], part) {
    this.x = (left + right) / 2;
    this.y = (bottom + top) / 2;
    this.scale = part * Math.min(this.width / (right - left), this.height / (top - bottom));
  }

  toCanvasX(x) {
    return this.width / 2 + (x - this.x) * this.scale;
  }
  toCanvasY(y) {
    return this.height / 2 - (y - this.y) * this.scale;
  }
  toPlane(canvasX, canvasY) {
    return [this.x + (canvasX - this.width / 2) / this.scale,
            this.y - (canvasY - this.height / 2) / this.scale];
  }

  pan(pixelsX, pixelsY) {
    this.x -= pixelsX / this.scale;
    this.y += pixelsY / this.scale;
  }

  /** The place under (canvasX, canvasY) stays where it is. */
  zoom(factor, canvasX, canvasY) {
    const [x, y] = this.toPlane(canvasX, canvasY);
    this.scale *= factor;
    const [movedX, movedY] = this.toPlane(canvasX, canvasY);
    this.x += x - movedX;
    this.y += y - movedY;
  }

  /** left, bottom, right, top of what is seen. */
  window() {
    const [left, top] = this.toPlane(0, 0);
    const [right, bottom] = this.toPlane(this.width, this.height);
    return [left, bottom, right, top];
  }
}
