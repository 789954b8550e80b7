#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens the report in headless Chromium and uses it: no error, a drawn viewer, exact angles by a click, the filter
of the claims, a phone, and paper. Usage: page_test.py QUADBOUND"""

import base64
import json
import os
import pathlib
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

QUADBOUND = ""
SECONDS = 60  # for one answer of a busy machine
DESKTOP = (1280, 900)
PHONE = (390, 844)


class Browser:
    """Chromium's DevTools protocol over a pair of pipes: messages end with a zero byte."""

    def __init__(self):
        self.profile = tempfile.mkdtemp(prefix="quadbound-page-")
        to_browser, self.writes = os.pipe()
        self.reads, from_browser = os.pipe()
        program = shutil.which("chromium-headless-shell") or shutil.which("chromium")
        if program is None:
            raise FileNotFoundError("no chromium: .ci/install test")

        def place_pipes():
            """Chromium reads from 3 and writes to 4."""
            kept = os.dup(to_browser), os.dup(from_browser)
            os.dup2(kept[0], 3)
            os.dup2(kept[1], 4)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
             "--disable-extensions", "--disable-background-networking", "--disable-component-update",
             "--remote-debugging-pipe", f"--user-data-dir={self.profile}", "about:blank"],
            preexec_fn=place_pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.number = 0
        self.session = None
        self.buffer = b""
        self.events = []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.ask(domain + ".enable")

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.writes)
        os.close(self.reads)
        shutil.rmtree(self.profile, ignore_errors=True)

    def next_message(self):
        end = time.monotonic() + SECONDS
        while b"\0" not in self.buffer:
            if not select.select([self.reads], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError(f"no answer in {SECONDS} s")
            part = os.read(self.reads, 1 << 20)
            if not part:
                raise EOFError("the browser ended")
            self.buffer += part
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.writes, json.dumps(request).encode() + b"\0")
        while True:
            message = self.next_message()
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self.events.append(message)

    def wait_for(self, method):
        while all(event["method"] != method for event in self.events):
            self.events.append(self.next_message())

    def run(self, script):
        """The value of an expression, a promise's once it is there."""
        answer = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"])
        return answer["result"].get("value")

    def size(self, width, height):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                 mobile=width < 600)
        self.settle()

    def open(self, address):
        self.ask("Page.navigate", url=address)
        self.wait_for("Page.loadEventFired")
        self.settle()

    def settle(self):
        """Until the next frame is drawn."""
        self.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)
        self.settle()

    def key(self, key):
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key)
        self.settle()

    def touch(self, kind, *places):
        self.ask("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in places])

    def errors(self):
        def is_error(event):
            method, about = event["method"], event["params"]
            return (method == "Runtime.exceptionThrown" or
                    method == "Runtime.consoleAPICalled" and about["type"] in ("error", "warning") or
                    method == "Log.entryAdded" and about["entry"]["level"] == "error")
        return [event["params"] for event in self.events if is_error(event)]


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="quadbound-report-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        subprocess.run([QUADBOUND, "reproduce", "--max-n", "100", "--trees", "20", "--audits", "100", "--out", cls.folder],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)
        cls.browser.open((cls.folder / "reproduction.html").as_uri())

    def setUp(self):
        self.browser.size(*DESKTOP)
        self.browser.run("claimsFilter.showAll(), viewer.part('colour').value = 0, viewer.open('plate'), document.activeElement.blur()")
        self.browser.run("document.getElementById('viewer').scrollIntoView()")
        self.browser.settle()

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [])

    def show(self, view):
        self.browser.run(f"viewer.open('{view}')")
        self.browser.settle()

    def press(self, part):
        self.browser.run(f"viewer.part('{part}').click()")
        self.browser.settle()

    def middle_of(self, quad):
        """On the screen."""
        return self.browser.run(f"""(() => {{
            const box = viewer.canvas.getBoundingClientRect(), v = viewer.mesh.verticesOf({quad});
            const mean = values => v.reduce((sum, i) => sum + values[i], 0) / 4;
            return [box.left + viewer.camera.toCanvasX(mean(viewer.mesh.x)),
                    box.top + viewer.camera.toCanvasY(mean(viewer.mesh.y))];
        }})()""")

    def details(self):
        return self.browser.run("viewer.part('details').innerText")

    def drawn_colours(self):
        """How many pixels the canvas has of each colour, by its hexadecimal code."""
        counts = self.browser.run("""(() => {
            const {canvas} = viewer, counts = new Map();
            const image = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            for (const pixel of new Uint32Array(image.data.buffer))
                counts.set(pixel, (counts.get(pixel) || 0) + 1);
            return [...counts];
        })()""")
        return {"#" + pixel.to_bytes(4, "little")[:3].hex(): count for pixel, count in counts}

    def test_every_view_draws(self):
        views = self.browser.run("viewer.views.map(view => view.id)")
        self.assertEqual(len(views), 11)
        for view in views:
            self.show(view)
            counts = self.drawn_colours()
            colours = self.browser.run("viewer.mesh.source.colours[0].classes.map(one => one.colour)")
            self.assertGreaterEqual(sum(colour in counts for colour in colours), 3, view)
            self.assertLess(counts.get("#ffffff", 0), 0.9 * sum(counts.values()), view)

    def test_every_colouring_draws_another_picture(self):
        pictures = []
        for colour in range(self.browser.run("viewer.mesh.source.colours.length")):
            self.browser.run(f"viewer.part('colour').value = {colour}, "
                             "viewer.part('colour').dispatchEvent(new Event('change'))")
            self.browser.settle()
            pictures.append(json.dumps(self.drawn_colours()))
            self.assertGreater(self.browser.run("viewer.part('legend').children.length"), 1)
        self.assertEqual(len(set(pictures)), 4)

    def test_a_click_selects_a_quad_and_shows_its_exact_angles(self):
        for quad in (0, 100, 200):
            self.browser.run(f"viewer.goTo({quad}), viewer.unselect()")
            self.browser.settle()
            self.browser.click(*self.middle_of(quad))
            self.assertEqual(self.browser.run("viewer.selection && viewer.selection.quad"), quad)
            text = self.details()
            self.assertIn(f"Quad {quad}", text)
            self.assertIn("Made by:", text)
            for tangent in self.browser.run(f"viewer.mesh.corners({quad}).map(exactAngle)"):
                self.assertIn(tangent, text)

    def test_a_drag_moves_and_selects_nothing(self):
        x, y = self.middle_of(0)
        before = self.browser.run("viewer.camera.x")
        self.browser.ask("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", clickCount=1)
        self.browser.ask("Input.dispatchMouseEvent", type="mouseMoved", x=x + 40, y=y, button="left", buttons=1)
        self.browser.ask("Input.dispatchMouseEvent", type="mouseReleased", x=x + 40, y=y, button="left", clickCount=1)
        self.browser.settle()
        moved = self.browser.run("(viewer.camera.x - %r) * viewer.camera.scale" % before)
        self.assertAlmostEqual(moved, -40, places=3)
        self.assertIsNone(self.browser.run("viewer.selection"))

    def test_the_worst_corners_are_the_judges(self):
        for mesh in ("plate", "fig-46", "fig-49", "fig-50", "fig-10"):
            report = json.loads((self.folder / f"{mesh}-report.json").read_text())
            worst = {claim["id"]: claim["worst"] for claim in report["claims"] if "worst" in claim}
            self.show(mesh)
            for button, claim in (("smallest", "min-angle"), ("largest", "max-angle")):
                self.press(button)
                self.assertEqual(self.browser.run("viewer.selection.quad"), worst[claim]["place"]["quad"])
                row = self.browser.run("document.querySelector('.details tr.worst').innerText").split("\t")
                self.assertEqual(row[0], str(worst[claim]["place"]["corner"]))
                self.assertEqual(row[1], f"{worst[claim]['degrees']:.4f}")
                self.assertEqual(row[2], worst[claim]["tan"])
                self.assertEqual(row[3], "within")

    def test_the_page_decides_every_corner_as_the_judge_does(self):
        for mesh in ("fig-46", "fig-49"):
            self.show(mesh)
            beyond = self.browser.run("""(() => {
                let count = 0;
                for (let quad = 0; quad < viewer.mesh.quadCount; ++quad)
                    viewer.mesh.corners(quad).forEach((corner, i) => {
                        const verdict = verdictOf(viewer.mesh, viewer.mesh.verticesOf(quad)[i], corner);
                        count += verdict.endsWith('the bound') ? 1 : 0;
                    });
                return count;
            })()""")
            self.assertEqual(beyond, 0)

    def test_keys_wheel_and_pinch_zoom(self):
        self.browser.run("viewer.canvas.focus({preventScroll: true})")
        scales = [self.browser.run("viewer.camera.scale")]
        x, y = self.middle_of(0)

        def has_grown():
            self.browser.settle()
            scales.append(self.browser.run("viewer.camera.scale"))
            self.assertGreater(scales[-1], scales[-2] * 1.05)

        self.browser.key("+")
        has_grown()
        self.browser.ask("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-120)
        has_grown()
        self.browser.touch("touchStart", (x - 20, y), (x + 20, y))
        self.browser.touch("touchMove", (x - 40, y), (x + 40, y))
        self.browser.touch("touchEnd")
        has_grown()
        self.browser.key("s")
        self.assertIsNotNone(self.browser.run("viewer.selection"))
        self.browser.key("0")
        self.assertAlmostEqual(self.browser.run("viewer.camera.scale"), scales[0])

    def shown_claims(self):
        return self.browser.run("claimsFilter.rows.filter(row => !row.hidden).map(row => row.id)")

    def type_filter(self, text):
        self.browser.run("claimsFilter.input.focus()")
        self.browser.ask("Input.insertText", text=text)
        self.browser.settle()

    def test_the_filter_finds_claims(self):
        claims = json.loads((pathlib.Path(__file__).parent / "claims.json").read_text())["claims"]
        self.assertEqual(len(self.shown_claims()), len(claims))
        self.type_filter("five quads")
        self.assertEqual(self.shown_claims(), ["lemma-11"])
        self.browser.run("claimsFilter.showAll()")
        self.type_filter("no such claim")
        self.assertEqual(self.shown_claims(), [])
        self.browser.run("claimsFilter.showAll(), claimsFilter.buttons[0].click()")
        verdict = self.browser.run("claimsFilter.buttons[0].dataset.verdict")
        self.assertEqual(len(self.shown_claims()), int(self.browser.run(
            "claimsFilter.buttons[0].querySelector('b').textContent")))
        self.assertEqual(set(self.browser.run(
            "claimsFilter.rows.filter(row => !row.hidden).map(row => row.querySelector('.verdict').textContent)")),
            {verdict})

    def test_a_link_to_a_hidden_claim_shows_it(self):
        self.type_filter("lemma 11")
        self.browser.run("new Promise(done => { window.addEventListener('hashchange', done, {once: true}); "
                         "location.hash = '#thm-13'; }).then(() => 0)")
        self.assertIn("thm-13", self.shown_claims())

    def test_links_lead_somewhere(self):
        dead = self.browser.run("""[...document.querySelectorAll('a[href^="#"]')].map(a => a.hash.slice(1)).filter(
            id => id.startsWith('view-') ? !viewer.views.some(view => `view-${view.id}` === id) :
                                           !document.getElementById(id))""")
        self.assertEqual(dead, [])
        twice = self.browser.run("""[...document.querySelectorAll('[id]')].map(e => e.id).filter(
            (id, i, all) => all.indexOf(id) !== i)""")
        self.assertEqual(twice, [])

    def test_a_phone_has_no_sideways_scroll(self):
        self.browser.size(*PHONE)
        self.press("smallest")
        self.assertEqual(self.browser.run("document.documentElement.scrollWidth"), PHONE[0])
        self.assertEqual(self.browser.run("innerWidth"), PHONE[0])
        self.assertLessEqual(self.browser.run("viewer.canvas.getBoundingClientRect().width"), PHONE[0])

    def test_a_finger_selects_on_a_phone(self):
        self.browser.size(*PHONE)
        self.browser.run("viewer.canvas.scrollIntoView({block: 'center'})")
        self.browser.run("viewer.goTo(100), viewer.unselect()")
        self.browser.settle()
        self.browser.touch("touchStart", self.middle_of(100))
        self.browser.touch("touchEnd")
        self.browser.settle()
        self.assertEqual(self.browser.run("viewer.selection && viewer.selection.quad"), 100)

    def print_media(self, media):
        self.browser.ask("Emulation.setEmulatedMedia", media=media)
        self.browser.settle()

    def test_paper_shows_every_claim_and_figure_and_no_controls(self):
        self.type_filter("five quads")
        self.print_media("print")
        self.addCleanup(self.print_media, "")
        texts = self.browser.run("""claimsFilter.rows.map(row => [...row.querySelectorAll(
            'td:not([data-head="see"])')].filter(cell => cell.textContent && cell.checkVisibility()).map(
            cell => cell.innerText).join(' '))""")
        claims = json.loads((pathlib.Path(__file__).parent / "claims.json").read_text())["claims"]
        self.assertEqual(len(texts), len(claims))
        for claim in claims:
            self.assertTrue(any(claim["id"] in text and claim["what"] in text for text in texts), claim)
        shown = "[...document.querySelectorAll('%s')].filter(part => part.checkVisibility()).length"
        self.assertEqual(self.browser.run(shown % "nav, button, input, select, canvas"), 0)
        figures = self.browser.run("""[...document.querySelectorAll('figure')].map(figure => {
            const picture = figure.querySelector('img, svg').getBoundingClientRect();
            return [picture.width, picture.height, getComputedStyle(figure).breakInside];
        })""")
        self.assertGreater(len(figures), 10)
        for width, height, break_inside in figures:
            self.assertGreater(min(width, height), 0)
            self.assertLess(height, 297 * 96 / 25.4)
            self.assertEqual(break_inside, "avoid")

    def test_it_is_printed(self):
        pdf = base64.b64decode(self.browser.ask("Page.printToPDF", preferCSSPageSize=True,
                                                generateTaggedPDF=False)["data"])
        self.assertTrue(pdf.startswith(b"%PDF-"))
        self.assertGreater(pdf.count(b"/Type /Page\n"), 10)
        folds = "[...document.querySelectorAll('details')].filter(fold => !fold.open).length"
        self.assertEqual(self.browser.run(folds), 0)


if __name__ == "__main__":
    QUADBOUND = sys.argv.pop(1)
    unittest.main()
