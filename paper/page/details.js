// SPDX-License-Identifier: Apache-2.0
// What is told of a mesh and of a selected quad, as HTML.
'use strict';

function element(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

function tableOf(head, rows) {
  const line = (tag, cells) => element('tr', {}, ...cells.map(cell => element(tag, {}, cell)));
  return element('table', {}, element('thead', {}, line('th', head)),
                 element('tbody', {}, ...rows.map(cells => line('td', cells))));
}

/** A number on a colour for each class, with how many quads it has. */
function legendOf(mesh, colour) {
  return mesh.source.colours[colour].classes.flatMap((quadClass, i) => {
    const count = mesh.quadsOfClass[colour][i].length;
    if (count === 0) return [];
    const swatch = element('span', {class: 'swatch', style: `background: ${quadClass.colour}`});
    return [element('li', {}, swatch, `${quadClass.label} `,
                    element('span', {class: 'count'}, count.toLocaleString('en')))];
  });
}

function boundsText({theorem, smallest, from_straight: straight}) {
  const arctangent = ([n, d]) => `arctan(${n}/${d})`;
  return `${theorem}: [${arctangent(smallest)}, 180° − ${arctangent(straight)}]`;
}

/** What the bounds say of a corner; decided in whole numbers. */
function verdictOf(mesh, vertex, corner) {
  const {smallest, from_straight: straight} = mesh.source.bounds;
  if (mesh.isWholeInputAngle(vertex)) return 'whole input angle, not judged';
  if (!isAtLeast(corner, smallest)) return 'below the bound';
  if (!isAtMostStraightMinus(corner, straight)) return 'above the bound';
  return 'within';
}

function exactAngle(corner) {
  const tangent = tangentText(corner);
  return tangent === null ? 'right angle' : tangent;
}

function angleTable(mesh, quad, corners) {
  const vertices = mesh.verticesOf(quad);
  return tableOf(['corner', 'degrees', 'tangent, exactly', 'bounds'], corners.map((corner, i) => [
    `${i}`, degreesOf(corner).toFixed(4), element('code', {}, exactAngle(corner)),
    verdictOf(mesh, vertices[i], corner)]));
}

function vertexTable(mesh, quad) {
  return tableOf(['corner', 'vertex', 'x, exactly', 'y, exactly'],
                 mesh.verticesOf(quad).map((vertex, i) => {
    const [x, y] = mesh.exactPosition(vertex).map(c => fractionText(c.numerator, c.denominator));
    return [`${i}`, mesh.input.has(vertex) ? `${vertex} (input)` : `${vertex}`,
            element('code', {}, x), element('code', {}, y)];
  }));
}

function quadDetails(mesh, quad, corners) {
  const made = mesh.labelOf('construction', quad), level = mesh.labelOf('cell level', quad);
  const title = element('h4', {}, `Quad ${quad.toLocaleString('en')}`);
  const how = element('p', {}, `Made by: ${made}. Level of its smallest cell: ${level}.`);
  const wide = table => element('div', {class: 'wide'}, table);
  return [title, how, wide(angleTable(mesh, quad, corners)), wide(vertexTable(mesh, quad)),
          element('p', {class: 'note'}, 'Tangents and bounds are computed in whole numbers from the ' +
                  'exact coordinates; the bounds are those of ' + boundsText(mesh.source.bounds) + '.')];
}
