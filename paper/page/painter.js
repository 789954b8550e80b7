// SPDX-License-Identifier: Apache-2.0
// Draws a mesh as a camera sees it.
'use strict';

const kSelected = '#c00000';

class Painter {
  constructor(context, camera) {
    this.context = context;
    this.camera = camera;
  }

  draw(mesh, colour, selection) {
    this.mesh = mesh;
    this.context.fillStyle = '#ffffff';
    this.context.fillRect(0, 0, this.camera.width, this.camera.height);
    const visible = this.visibleQuads(colour);
    this.fill(colour, visible);
    this.strokeQuads(visible.flat());
    this.strokeBoundary();
    this.dotInput();
    if (selection) this.mark(selection);
  }

  /** Per class of the colour. */
  visibleQuads(colour) {
    const [left, bottom, right, top] = this.camera.window();
    const boxes = this.mesh.boxes;
    const isSeen = quad => boxes[4 * quad] <= right && boxes[4 * quad + 2] >= left &&
                           boxes[4 * quad + 1] <= top && boxes[4 * quad + 3] >= bottom;
    return this.mesh.quadsOfClass[colour].map(quads => quads.filter(isSeen));
  }

  addQuad(quad) {
    const {context, camera, mesh} = this;
    for (let i = 0; i < 4; ++i) {
      const vertex = mesh.quads[4 * quad + i];
      const x = camera.toCanvasX(mesh.x[vertex]), y = camera.toCanvasY(mesh.y[vertex]);
      if (i === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
    context.closePath();
  }

  fill(colour, visible) {
    this.mesh.source.colours[colour].classes.forEach((quadClass, i) => {
      this.context.beginPath();
      visible[i].forEach(quad => this.addQuad(quad));
      this.context.fillStyle = quadClass.colour;
      this.context.fill();
    });
  }

  /** Edges of quads of a few pixels are thin, of less they would hide the colours. */
  strokeQuads(quads) {
    const sizeOf = quad => this.camera.scale * Math.max(
        this.mesh.boxes[4 * quad + 2] - this.mesh.boxes[4 * quad],
        this.mesh.boxes[4 * quad + 3] - this.mesh.boxes[4 * quad + 1]);
    const small = quads.filter(quad => sizeOf(quad) > 2.5 && sizeOf(quad) <= 12);
    const large = quads.filter(quad => sizeOf(quad) > 12);
    this.strokeAll(small, 'rgba(0, 0, 0, 0.35)', 0.5);
    this.strokeAll(large, 'rgba(0, 0, 0, 0.75)', 0.9);
  }
  strokeAll(quads, style, width) {
    this.context.beginPath();
    quads.forEach(quad => this.addQuad(quad));
    this.stroke(style, width);
  }
  stroke(style, width) {
    this.context.strokeStyle = style;
    this.context.lineWidth = width;
    this.context.lineJoin = 'round';
    this.context.stroke();
  }

  strokeBoundary() {
    const {context, camera, mesh} = this;
    context.beginPath();
    for (const [from, to] of mesh.boundary) {
      context.moveTo(camera.toCanvasX(mesh.x[from]), camera.toCanvasY(mesh.y[from]));
      context.lineTo(camera.toCanvasX(mesh.x[to]), camera.toCanvasY(mesh.y[to]));
    }
    this.stroke('#000000', 1.6);
  }

  /** The vertices or points of the input. */
  dotInput() {
    const {context, camera, mesh} = this;
    context.beginPath();
    for (const vertex of mesh.source.input) {
      const x = camera.toCanvasX(mesh.x[vertex]), y = camera.toCanvasY(mesh.y[vertex]);
      context.moveTo(x + 2, y);
      context.arc(x, y, 2, 0, 2 * Math.PI);
    }
    context.fillStyle = '#000000';
    context.fill();
  }

  // --- the selected quad -------------------------------------------------------------------------

  mark({quad, corner, degrees}) {
    this.context.beginPath();
    this.addQuad(quad);
    this.stroke(kSelected, 2.5);
    if (corner !== undefined) this.ringCorner(quad, corner);
    const size = (this.mesh.boxes[4 * quad + 2] - this.mesh.boxes[4 * quad]) * this.camera.scale;
    if (size > 110) this.labelCorners(quad, degrees);
  }

  /** On the canvas, of vertex i of the quad. */
  placeOf(quad, i) {
    const vertex = this.mesh.quads[4 * quad + i];
    return [this.camera.toCanvasX(this.mesh.x[vertex]), this.camera.toCanvasY(this.mesh.y[vertex])];
  }

  ringCorner(quad, corner) {
    this.context.beginPath();
    this.context.arc(...this.placeOf(quad, corner), 9, 0, 2 * Math.PI);
    this.stroke(kSelected, 2);
  }

  /** Degrees, from each corner a part of the way to the middle. */
  labelCorners(quad, degrees) {
    const {context} = this;
    const places = [0, 1, 2, 3].map(i => this.placeOf(quad, i));
    const middle = [0, 1].map(axis => places.reduce((sum, place) => sum + place[axis], 0) / 4);
    context.font = '600 13px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    places.forEach((place, i) => {
      const [x, y] = place.map((value, axis) => value + 0.36 * (middle[axis] - value));
      const text = `${degrees[i].toFixed(2)}°`;
      context.strokeStyle = 'rgba(255, 255, 255, 0.9)';
      context.lineWidth = 4;
      context.strokeText(text, x, y);
      context.fillStyle = '#000000';
      context.fillText(text, x, y);
    });
  }
}
