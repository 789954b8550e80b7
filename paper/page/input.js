// SPDX-License-Identifier: Apache-2.0
// Mouse, wheel, fingers and keys of the viewer.
'use strict';

const kClickPixels = 5;  // a finger that moves no further selects

function placeOn(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/** The middle of the pointers, and how far apart the first two are. */
function spanOf(pointers) {
  const places = [...pointers.values()];
  const middle = [0, 1].map(
      axis => places.reduce((sum, place) => sum + place[axis], 0) / places.length);
  const apart = places.length < 2 ? 0 :
      Math.hypot(places[0][0] - places[1][0], places[0][1] - places[1][1]);
  return {middle, apart};
}

/** One pointer drags, two pinch, one that stays selects. */
function listenToFingers(viewer) {
  const {canvas} = viewer;
  const pointers = new Map();
  let travelled = 0;

  canvas.addEventListener('pointerdown', event => {
    if (pointers.size === 0) travelled = 0;
    pointers.set(event.pointerId, placeOn(canvas, event));
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', event => {
    if (!pointers.has(event.pointerId)) return;
    const before = spanOf(pointers);
    pointers.set(event.pointerId, placeOn(canvas, event));
    const after = spanOf(pointers);
    const [x, y] = [0, 1].map(axis => after.middle[axis] - before.middle[axis]);
    travelled += Math.hypot(x, y) + Math.abs(after.apart - before.apart);
    viewer.pan(x, y);
    if (before.apart > 0 && after.apart > 0) viewer.zoom(after.apart / before.apart, ...after.middle);
  });
  canvas.addEventListener('pointerup', event => {
    if (pointers.delete(event.pointerId) && pointers.size === 0 && travelled < kClickPixels)
      viewer.selectAt(...placeOn(canvas, event));
  });
  canvas.addEventListener('pointercancel', event => pointers.delete(event.pointerId));
  listenToWheel(viewer);
}

function listenToWheel(viewer) {
  const kPixelsPerLine = 16;
  viewer.canvas.addEventListener('wheel', event => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? kPixelsPerLine : 1);
    viewer.zoom(Math.exp(-0.0015 * pixels), ...placeOn(viewer.canvas, event));
  }, {passive: false});
}

function listenToKeys(viewer) {
  const kStep = 60;
  const actions = {
    ArrowLeft: () => viewer.pan(kStep, 0),
    ArrowRight: () => viewer.pan(-kStep, 0),
    ArrowUp: () => viewer.pan(0, kStep),
    ArrowDown: () => viewer.pan(0, -kStep),
    '+': () => viewer.zoomInMiddle(1.25),
    '=': () => viewer.zoomInMiddle(1.25),
    '-': () => viewer.zoomInMiddle(0.8),
    '0': () => viewer.showAll(),
    s: () => viewer.goToWorst('smallest'),
    l: () => viewer.goToWorst('largest'),
    Enter: () => viewer.selectAt(viewer.camera.width / 2, viewer.camera.height / 2),
    Escape: () => viewer.unselect(),
  };
  viewer.canvas.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
  });
}
