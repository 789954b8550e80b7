#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of theorem-1.md from its coordinates: python3 paper/figures/draw.py"""

import pathlib

HERE = pathlib.Path(__file__).parent
UNIT = 60  # pixels
MARGIN = 24

C, D = (1, 1), (1, 3)
A, B, EA, EB = (3, 1), (3, 3), (5 / 2, 1 / 2), (5 / 2, 7 / 2)
S1, S2, S3, S4 = (5 / 2, 1 / 2), (5 / 2, 3 / 2), (5 / 2, 5 / 2), (5 / 2, 7 / 2)
E1, E2, E3, E4 = (9 / 4, 1 / 4), (9 / 4, 7 / 4), (9 / 4, 9 / 4), (9 / 4, 15 / 4)
M, M2 = (3 / 2, 3 / 2), (3 / 2, 5 / 2)
LEAF_A, LEAF_B = [(2, 0, 2)], [(2, 2, 2)]
SPLIT_A = [(2, 0, 1), (2, 1, 1), (3, 0, 1), (3, 1, 1)]
SPLIT_B = [(2, 2, 1), (2, 3, 1), (3, 2, 1), (3, 3, 1)]
LEFT = [(0, 0, 2), (0, 2, 2)]


class Panel:
    """One case: cells (x, y, side), quads, names of points; extras are open circles."""

    def __init__(self, title, cells, quads, names, extras=(), gone=()):
        self.title, self.cells, self.quads = title, cells, quads
        self.names, self.extras, self.gone = names, set(extras), gone

    def size(self):
        return (max(x + s for x, _, s in self.cells), max(y + s for _, y, s in self.cells))

    def draw(self, left, top):
        width, height = self.size()
        place = lambda p: (left + MARGIN + UNIT * p[0], top + MARGIN + UNIT * (height - p[1]))
        out = [f'<text x="{left + MARGIN}" y="{top + 15}" font-weight="bold">{self.title}</text>']
        for quad in self.quads:
            points = " ".join("%g,%g" % place(p) for p in quad)
            out.append(f'<polygon points="{points}" fill="#cfe3f5" stroke="#0b5fa5" stroke-width="1.6"/>')
        for x, y, side in self.cells:
            px, py = place((x, y + side))
            out.append(f'<rect x="{px:g}" y="{py:g}" width="{side * UNIT}" height="{side * UNIT}" '
                       'fill="none" stroke="#999" stroke-dasharray="3 3"/>')
        for p in self.gone:
            px, py = place(p)
            out.append(f'<path d="M{px - 4:g} {py - 4:g}l8 8m0 -8l-8 8" stroke="#d1700b" stroke-width="2"/>')
        for name, p in self.names.items():
            px, py = place(p)
            fill = "white" if name in self.extras else "#222"
            out.append(f'<circle cx="{px:g}" cy="{py:g}" r="3.5" fill="{fill}" stroke="#222"/>')
            if name in self.extras:  # away from the centre it lies beside
                out.append(f'<text x="{px - 7:g}" y="{py + 4:g}" text-anchor="end">{name}</text>')
            else:
                out.append(f'<text x="{px + 6:g}" y="{py - 5:g}">{name}</text>')
        return "\n".join(out)


def write(name, panels, columns):
    width = max(p.size()[0] for p in panels) * UNIT + 2 * MARGIN
    height = max(p.size()[1] for p in panels) * UNIT + 2 * MARGIN
    rows = (len(panels) + columns - 1) // columns
    body = "\n".join(p.draw(i % columns * width, i // columns * height) for i, p in enumerate(panels))
    (HERE / name).write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {columns * width:g} {rows * height:g}" '
        f'width="{columns * width:g}" height="{rows * height:g}" font-family="sans-serif" font-size="13">\n'
        f'<rect width="100%" height="100%" fill="white"/>\n{body}\n</svg>\n')


def two_leaf():
    e3, e2 = (9 / 4, 7 / 4), (9 / 4, 9 / 4)
    return [
        Panel("L, L", LEFT + LEAF_A + LEAF_B, [(C, EA, A, D), (D, A, B, EB)],
              {"c": C, "d": D, "A": A, "B": B, "eA": EA, "eB": EB}, ("eA", "eB")),
        Panel("L, 2", LEFT + LEAF_A + SPLIT_B, [(C, EA, A, S3), (C, S3, S4, D)],
              {"c": C, "d": D, "A": A, "eA": EA, "s3": S3, "s4": S4}, ("eA",)),
        Panel("2, 2", LEFT + SPLIT_A + SPLIT_B,
              [(C, S1, S2, M), (M, S2, S3, M2), (M2, S3, S4, D), (C, M, M2, D)],
              {"c": C, "d": D, "s1": S1, "s2": S2, "s3": S3, "s4": S4, "m": M, "m'": M2}, ("m", "m'")),
        Panel("L, 4", LEFT + LEAF_A + SPLIT_B, [(C, EA, A, e3), (C, e3, S3, D), (D, S3, S4, E4)],
              {"c": C, "d": D, "A": A, "eA": EA, "s3": S3, "s4": S4, "e3'": e3, "e4": E4},
              ("eA", "e3'", "e4"), (E3,)),
        Panel("4, 2", LEFT + SPLIT_A + SPLIT_B, [(C, E1, S1, S2), (C, S2, e2, D), (D, e2, S3, S4)],
              {"c": C, "d": D, "s1": S1, "s2": S2, "s3": S3, "s4": S4, "e1": E1, "e2'": e2},
              ("e1", "e2'"), (E2,)),
        Panel("4, 4", LEFT + SPLIT_A + SPLIT_B, [(C, E1, S1, S2), (C, S2, S3, D), (D, S3, S4, E4)],
              {"c": C, "d": D, "s1": S1, "s2": S2, "s3": S3, "s4": S4, "e1": E1, "e4": E4},
              ("e1", "e4"), (E2, E3)),
    ]


def t3():
    a, d, b = (1, 3), (3, 3), (3, 1)
    nw, ne, se = (1 / 2, 3 / 2), (3 / 2, 3 / 2), (3 / 2, 1 / 2)
    inner = [(0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 1)]
    outer = [(0, 2, 2), (2, 2, 2), (2, 0, 2)]
    deeper = [(0, 0, .5), (0, .5, .5), (.5, 0, .5), (.5, .5, .5)]
    e, f = (1 / 4, 7 / 4), (7 / 4, 1 / 4)
    names = {"a": a, "d": d, "b": b, "nw": nw, "ne": ne, "se": se}
    return [
        Panel("T3, split child T4", inner + outer, [(a, nw, ne, d), (d, ne, se, b)], names),
        Panel("T3, split child not T4", inner + deeper + outer,
              [(a, e, nw, ne), (b, ne, se, f), (a, ne, b, d)], {**names, "e": e, "f": f},
              ("e", "f"), ((7 / 4, 7 / 4),)),
    ]


def one_four():
    e, e_a, two = (3 / 2, 3 / 2), (5 / 2, 3 / 2), [(0, 0, 2)]
    return [
        Panel("1|1", two + LEAF_A, [(C, A, e_a, e)], {"c": C, "A": A, "eA": e_a, "e": e}, ("e", "eA")),
        Panel("1|2", two + SPLIT_A, [(C, S1, S2, e)], {"c": C, "s1": S1, "s2": S2, "e": e}, ("e",)),
        Panel("1|4", two + SPLIT_A, [(C, E1, S1, S2), (C, S2, E2, e)],
              {"c": C, "s1": S1, "s2": S2, "e": e, "e1": E1, "e2": E2}, ("e", "e1", "e2")),
    ]


write("two-leaf.svg", two_leaf(), 3)
write("template-t3.svg", t3(), 2)
write("stitch-1-4.svg", one_four(), 3)
