// SPDX-License-Identifier: Apache-2.0
// A mesh as paper/viewer_mesh.cpp writes it: exact coordinates for what is told of a quad, doubles
// for what is drawn of it.
'use strict';

class ViewerMesh {
  constructor(source) {
    this.source = source;
    this.xy = source.xy.split(' ');
    this.quads = source.quads;
    this.quadCount = source.quads.length / 4;
    this.input = new Set(source.input);
    this.setDrawnCoordinates();
    this.setBoxes();
    this.setEdges();
    this.quadsOfClass = source.colours.map(colour => this.sortIntoClasses(colour));
  }

  // --- exact -----------------------------------------------------------------------------------

  /** Both coordinates as fractions, in the units of the input. */
  exactPosition(vertex) {
    const rational = this.source.rational[vertex];
    if (rational) return rational.map(parseFraction);
    return [2 * vertex, 2 * vertex + 1].map(i => this.fromLattice(BigInt(this.xy[i])));
  }

  /** k * 2^exponent. */
  fromLattice(k) {
    const exponent = this.source.exponent;
    return exponent < 0 ? {numerator: k, denominator: 1n << BigInt(-exponent)} :
                          {numerator: k << BigInt(exponent), denominator: 1n};
  }

  /** The four corners of a quad, exactly: its vertices are brought to one denominator. */
  corners(quad) {
    const positions = this.verticesOf(quad).map(vertex => this.exactPosition(vertex));
    let common = 1n;
    for (const {denominator} of positions.flat())
      common *= denominator / greatestCommonDivisor(common, denominator);
    const points = positions.map(([x, y]) => ({
      x: x.numerator * (common / x.denominator), y: y.numerator * (common / y.denominator)}));
    return points.map((at, i) => cornerAt(at, points[(i + 1) % 4], points[(i + 3) % 4]));
  }

  verticesOf(quad) {
    return this.quads.slice(4 * quad, 4 * quad + 4);
  }

  /** The angle of the input stays whole there: no bound judges it. */
  isWholeInputAngle(vertex) {
    return this.source.polygon && this.input.has(vertex) && this.quadsAt[vertex] === 1;
  }

  // --- drawn -----------------------------------------------------------------------------------

  setDrawnCoordinates() {
    const unit = 2 ** this.source.exponent;
    const count = this.xy.length / 2;
    this.x = Float64Array.from({length: count}, (_, v) => Number(this.xy[2 * v]) * unit);
    this.y = Float64Array.from({length: count}, (_, v) => Number(this.xy[2 * v + 1]) * unit);
    for (const vertex of Object.keys(this.source.rational)) {
      const [x, y] = this.source.rational[vertex].map(parseFraction);
      this.x[vertex] = Number(x.numerator) / Number(x.denominator);
      this.y[vertex] = Number(y.numerator) / Number(y.denominator);
    }
  }

  /** left, bottom, right, top of each quad and of all. */
  setBoxes() {
    this.boxes = new Float64Array(4 * this.quadCount);
    this.box = [Infinity, Infinity, -Infinity, -Infinity];
    for (let quad = 0; quad < this.quadCount; ++quad) {
      const vertices = this.verticesOf(quad);
      const xs = vertices.map(v => this.x[v]), ys = vertices.map(v => this.y[v]);
      const box = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
      this.boxes.set(box, 4 * quad);
      this.box = this.box.map((value, i) => i < 2 ? Math.min(value, box[i]) : Math.max(value, box[i]));
    }
  }

  /** The boundary: edges of one quad only; and how many quads each vertex has. */
  setEdges() {
    const unpaired = new Map();
    this.quadsAt = new Uint32Array(this.x.length);
    for (let i = 0; i < this.quads.length; ++i) {
      const from = this.quads[i], to = this.quads[i % 4 === 3 ? i - 3 : i + 1];
      ++this.quadsAt[from];
      const key = Math.min(from, to) * this.x.length + Math.max(from, to);
      if (!unpaired.delete(key)) unpaired.set(key, [from, to]);
    }
    this.boundary = [...unpaired.values()];
  }

  sortIntoClasses(colour) {
    const lists = colour.classes.map(() => []);
    for (let quad = 0; quad < this.quadCount; ++quad) lists[this.classOf(colour, quad)].push(quad);
    return lists;
  }
  classOf(colour, quad) {
    return colour.of_quad.charCodeAt(quad) - 48;
  }
  labelOf(title, quad) {
    const colour = this.source.colours.find(candidate => candidate.title === title);
    return colour ? colour.classes[this.classOf(colour, quad)].label : '';
  }

  /** The quad around a place, or -1. */
  quadAround(x, y) {
    for (let quad = 0; quad < this.quadCount; ++quad) {
      const [left, bottom, right, top] = this.boxes.subarray(4 * quad, 4 * quad + 4);
      if (left <= x && x <= right && bottom <= y && y <= top && this.isInside(quad, x, y)) return quad;
    }
    return -1;
  }

  /** Quads are convex and counter-clockwise. */
  isInside(quad, x, y) {
    const vertices = this.verticesOf(quad);
    return vertices.every((from, i) => {
      const to = vertices[(i + 1) % 4];
      return (this.x[to] - this.x[from]) * (y - this.y[from]) >=
             (this.y[to] - this.y[from]) * (x - this.x[from]);
    });
  }
}
