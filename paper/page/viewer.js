// SPDX-License-Identifier: Apache-2.0
// The mesh viewer: pan, zoom, colours, the worst corners, and a selected quad.
'use strict';

class Viewer {
  constructor(root) {
    this.part = name => root.querySelector(`[data-part="${name}"]`);
    this.canvas = this.part('canvas');
    this.camera = new Camera();
    this.painter = new Painter(this.canvas.getContext('2d'), this.camera);
    this.views = JSON.parse(document.getElementById('views').textContent);
    this.meshes = new Map();
    this.fillMenu();
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.resize();
    this.open(this.views[0].id);
  }

  // --- what is shown -----------------------------------------------------------------------------

  /** Meshes are decoded when they are looked at first. */
  meshOf(id) {
    if (!this.meshes.has(id)) {
      const source = JSON.parse(document.getElementById(`mesh-${id}`).textContent);
      this.meshes.set(id, new ViewerMesh(source));
    }
    return this.meshes.get(id);
  }

  open(id) {
    this.view = this.views.find(candidate => candidate.id === id);
    this.mesh = this.meshOf(this.view.mesh);
    this.part('view').value = id;
    this.fillColours();
    this.fillFacts();
    this.unselect();
    this.showAll();
  }

  showAll() {
    if (this.view.window) this.camera.show(this.view.window, 1);
    else this.camera.show(this.mesh.box, 0.94);
    this.redraw();
  }

  get colour() {
    return Number(this.part('colour').value);
  }

  resize() {
    const {width, height} = this.canvas.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    this.camera.width = width;
    this.camera.height = height;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.getContext('2d').setTransform(ratio, 0, 0, ratio, 0, 0);
    if (this.mesh) this.redraw();
  }

  /** Once per frame, however often it is asked for. */
  redraw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.painter.draw(this.mesh, this.colour, this.selection);
    });
  }

  // --- the selected quad -------------------------------------------------------------------------

  select(quad, corner) {
    const corners = this.mesh.corners(quad);
    this.selection = {quad, corner, degrees: corners.map(degreesOf)};
    this.part('details').replaceChildren(...quadDetails(this.mesh, quad, corners));
    if (corner !== undefined)
      this.part('details').querySelectorAll('tbody')[0].rows[corner].classList.add('worst');
    this.part('quad').value = quad;
    this.redraw();
  }

  unselect() {
    this.selection = undefined;
    this.part('details').replaceChildren(this.part('help').content.cloneNode(true));
    this.part('quad').value = '';
    this.redraw();
  }

  /** Selects a quad and brings it near. */
  goTo(quad, corner) {
    this.camera.show(this.mesh.boxes.subarray(4 * quad, 4 * quad + 4), 0.4);
    this.select(quad, corner);
  }

  goToWorst(which) {
    const worst = this.mesh.source.worst[which];
    this.goTo(worst.quad, worst.corner);
  }

  goToNumber() {
    const quad = Number(this.part('quad').value);
    if (Number.isInteger(quad) && quad >= 0 && quad < this.mesh.quadCount) this.goTo(quad);
  }

  selectAt(canvasX, canvasY) {
    const quad = this.mesh.quadAround(...this.camera.toPlane(canvasX, canvasY));
    if (quad < 0) this.unselect();
    else this.select(quad);
  }

  // --- menus -------------------------------------------------------------------------------------

  fillMenu() {
    this.part('view').replaceChildren(
        ...this.views.map(view => element('option', {value: view.id}, `${view.id}: ${view.text}`)));
  }

  /** Keeps the colour of the mesh before. */
  fillColours() {
    const menu = this.part('colour');
    const before = menu.value || '0';
    menu.replaceChildren(...this.mesh.source.colours.map(
        (colour, i) => element('option', {value: `${i}`}, colour.title)));
    menu.value = before;
    this.fillLegend();
  }

  fillLegend() {
    this.part('legend').replaceChildren(...legendOf(this.mesh, this.colour));
  }

  fillFacts() {
    const {worst, bounds} = this.mesh.source;
    const {degrees: smallest} = worst.smallest, {degrees: largest} = worst.largest;
    this.part('facts').textContent =
        `${this.mesh.quadCount.toLocaleString('en')} quads, ` +
        `${this.mesh.x.length.toLocaleString('en')} vertices, angles ${smallest.toFixed(2)}° to ` +
        `${largest.toFixed(2)}°; ${boundsText(bounds)}.`;
  }

  listen() {
    const onClick = (name, action) => this.part(name).addEventListener('click', action);
    this.part('view').addEventListener('change', event => this.open(event.target.value));
    this.part('colour').addEventListener('change', () => {
      this.fillLegend();
      this.redraw();
    });
    this.part('go').addEventListener('submit', event => {
      event.preventDefault();
      this.goToNumber();
    });
    onClick('smallest', () => this.goToWorst('smallest'));
    onClick('largest', () => this.goToWorst('largest'));
    onClick('all', () => this.showAll());
    onClick('in', () => this.zoomInMiddle(1.5));
    onClick('out', () => this.zoomInMiddle(1 / 1.5));
    listenToFingers(this);
    listenToKeys(this);
  }

  zoomInMiddle(factor) {
    this.zoom(factor, this.camera.width / 2, this.camera.height / 2);
  }
  zoom(factor, canvasX, canvasY) {
    this.camera.zoom(factor, canvasX, canvasY);
    this.redraw();
  }
  pan(pixelsX, pixelsY) {
    this.camera.pan(pixelsX, pixelsY);
    this.redraw();
  }
}

/** #view-ID in the address opens that view. */
function followAddress(viewer) {
  const id = location.hash.replace(/^#view-/, '');
  if (id === location.hash || !viewer.views.some(view => view.id === id)) return;
  viewer.open(id);
  document.getElementById('viewer').scrollIntoView();
}

const viewer = new Viewer(document.getElementById('viewer'));
followAddress(viewer);
window.addEventListener('hashchange', () => followAddress(viewer));
document.addEventListener('click', event => {  // a second click on a link changes no address
  const link = event.target.closest('a');
  if (link && link.hash === location.hash) followAddress(viewer);
});
