#!/usr/bin/env python3
"""The page that plays a flight, in headless Chromium: page.py CONVERT...

CONVERT is a command that takes two files, the flight and what it becomes, as `vides convert`.
Driven through WebDriver with the standard library alone; needs chromium and chromedriver. The
poses that the page is held against are those of the format csv, projected here.
"""

import base64
import http.server
import json
import math
import os
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
import zlib

MARK = (0.25, 0.35, -0.15)
TITLE = 'A "title" of \'quotes\' </script><script>alert(1)</script> <img src=x onerror=alert(2)> & <!-- é 🎥'
COMMENT = "one line\n</script><b>another</b>\n]]> \\u003c"
NAME = "</canvas> <i>name"

FLIGHT = f"""
version = 1
title = {json.dumps(TITLE, ensure_ascii=False)}
comment = {json.dumps(COMMENT)}
fps = 25.0
first_frame = 101
[space]
unit = "m<b>"
UP
CENTRE
[[node]]
name = "mark"
kind = "object"
position = [M0, M1, M2]
colour = [1.0, 0.0, 1.0]
[node.mesh]
points = [[0.0, 0.0, 0.0]]
[[node]]
name = "frame"
kind = "object"
[node.mesh]
points = [[P0], [P1], [P2]]
lines = [[0, 1], [1, 2]]
[[node]]
name = "camera"
kind = "camera"
[node.path]
[[node.path.point]]
name = {json.dumps(NAME)}
position = [A0]
[[node.path.point.orientation]]
target = [T0]
zoom_mm = 20.0
roll_degrees = 0.0
[[node.path.point]]
position = [A1]
[[node.path.point.orientation]]
target = [T0]
zoom_mm = 40.0
roll_degrees = 35.0
[[node.path.point]]
name = "end"
position = [A2]
[[node.path.point.orientation]]
target = [T0]
zoom_mm = 30.0
roll_degrees = -20.0
"""


def flight(up, centre):
    """The flight about a centre; z up: the same, turned."""
    turn = (lambda x, y, z: (x, y, z)) if up == "y" else (lambda x, y, z: (x, -z, y))
    place = lambda *at: ", ".join(repr(float(a + b)) for a, b in zip(turn(*at), centre))
    text = FLIGHT.replace("UP", f'up = "{up}"')
    text = text.replace("CENTRE", f"centre = {list(map(float, centre))}\nhalf_size = 1.0")
    text = text.replace("M0, M1, M2", place(*MARK))
    for name, at in {
        "P0": (0.3, 0, 0.3), "P1": (-0.3, 0, 0.3), "P2": (0, 0.5, 0), "T0": (0, 0.3, 0),
        "A0": (-0.6, 0.2, 0.8), "A1": (0.1, 0.6, 0.9), "A2": (0.8, 0.1, 0.4),
    }.items():
        text = text.replace(f"[{name}]", f"[{place(*at)}]")
    return text, [float(a + b) for a, b in zip(turn(*MARK), centre)]


class Browser:
    """A session of WebDriver."""

    def __init__(self, *arguments):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.folder = tempfile.mkdtemp()
        self.driver = subprocess.Popen(
            ["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self.root = f"http://127.0.0.1:{port}/session"
        options = [
            "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--disable-quic", "--no-first-run", "--disable-background-networking",
            "--disable-component-update", "--disable-sync", "--hide-scrollbars",
            "--force-device-scale-factor=1", f"--user-data-dir={self.folder}", *arguments,
        ]
        wanted = {
            "browserName": "chrome",
            "goog:chromeOptions": {"args": options},
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
        }
        for _ in range(100):
            try:
                urllib.request.urlopen(f"http://127.0.0.1:{port}/status").read()
                break
            except OSError:
                time.sleep(0.1)
        made = self.call("POST", "", {"capabilities": {"alwaysMatch": wanted}})
        self.root += "/" + made["sessionId"]

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.root + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"].splitlines()[0]) from None

    def run(self, script, *arguments):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def open(self, address):
        self.call("POST", "/url", {"url": address})

    def size(self, width, height):
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.settle()

    def cdp(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def media(self, **features):
        listed = [{"name": name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.cdp("Emulation.setEmulatedMedia", features=listed)

    def settle(self):
        """Until what was asked for is drawn."""
        self.call("POST", "/execute/async", {
            "script": "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));",
            "args": [],
        })

    def keys(self, *keys):
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})
        self.settle()

    def drag(self, *places):
        moves = [{"type": "pointerMove", "x": int(x), "y": int(y), "duration": 0} for x, y in places]
        actions = [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:], {"type": "pointerUp", "button": 0}]
        self.call("POST", "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": actions}]})
        self.settle()

    def picture(self, x=0, y=0, width=1200, height=800):
        """A PNG of a part of the window; equal pixels are equal bytes."""
        clip = {"x": x, "y": y, "width": width, "height": height, "scale": 1}
        return base64.b64decode(self.cdp("Page.captureScreenshot", clip=clip)["data"])

    def log(self, kind):
        return self.call("POST", "/se/log", {"type": kind})

    def close(self):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            shutil.rmtree(self.folder, ignore_errors=True)


def decode(png):
    """A PNG of 8 bits a channel, without interlacing, as rows of bytes and bytes a pixel."""
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at : at + 8])
        body = png[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colours = struct.unpack(">IIBB", body[:10])
            assert bits == 8 and colours in (2, 6)
        data += body if kind == b"IDAT" else b""
        at += size + 12
    step = 3 if colours == 2 else 4
    raw, rows, before = zlib.decompress(data), [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        kind, row = raw[start], bytearray(raw[start + 1 : start + 1 + width * step])
        for x in range(len(row)):
            left = row[x - step] if x >= step else 0
            up, corner = before[x], before[x - step] if x >= step else 0
            if kind == 1:
                row[x] = row[x] + left & 255
            elif kind == 2:
                row[x] = row[x] + up & 255
            elif kind == 3:
                row[x] = row[x] + (left + up) // 2 & 255
            elif kind == 4:
                guess = left + up - corner
                nearest = min((left, up, corner), key=lambda value: abs(guess - value))
                row[x] = row[x] + nearest & 255
        rows.append(row)
        before = row
    return [[tuple(row[x : x + 3]) for x in range(0, len(row), step)] for row in rows]


def marked(browser, box, near):
    """The middle of what is magenta, weighted by how much it is so, within 20 pixels of a place of
    the camera's picture."""
    left, top = (math.floor(edge + at) - 20 for edge, at in zip((box["left"], box["top"]), near))
    sums = [0, 0, 0]
    for y, row in enumerate(decode(browser.picture(left, top, 41, 41))):
        for x, (red, green, blue) in enumerate(row):
            weight = max(min(red, blue) - green - 80, 0)
            sums = [sums[0] + weight, sums[1] + weight * (x + 0.5), sums[2] + weight * (y + 0.5)]
    assert sums[0], "the mark is not to be seen"
    return sums[1] / sums[0] + left - box["left"], sums[2] / sums[0] + top - box["top"]


def projected(row, mark, width, height):
    """Where a pose of the csv sees a place: pixels from the upper left of the picture."""
    eye, view, up = row[1:4], row[4:7], row[7:10]
    right = [view[1] * up[2] - view[2] * up[1], view[2] * up[0] - view[0] * up[2], view[0] * up[1] - view[1] * up[0]]
    away = [a - b for a, b in zip(mark, eye)]
    along = lambda axis: sum(a * b for a, b in zip(away, axis))
    # The film is 24 mm high, `zoom` mm behind the lens.
    pixels = row[10] / 24 * height
    return width / 2 + along(right) / along(view) * pixels, height / 2 - along(up) / along(view) * pixels


class Server:
    """Serves a folder and keeps what was asked for."""

    def __init__(self, folder):
        self.asked = asked = []

        class Handler(http.server.SimpleHTTPRequestHandler):
            def __init__(self, *arguments):
                super().__init__(*arguments, directory=folder)

            def log_message(self, *_):
                asked.append(self.path)

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.address = f"http://127.0.0.1:{self.server.server_port}"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()


def check(what, held, *seen):
    if not held:
        sys.exit(f"page.py: {what}: {' '.join(map(str, seen))}")
    print(f"{what}{': ' if seen else ''}{' '.join(map(str, seen))}")


def written(convert, folder, name, up="y", centre=(0, 0, 0), options=()):
    """Makes a flight's page and poses; the mark's place and the rows of the csv."""
    text, mark = flight(up, centre)
    source, page, poses = (os.path.join(folder, name + end) for end in (".vid", ".html", ".csv"))
    with open(source, "w", encoding="utf-8") as file:
        file.write(text)
    subprocess.run([*convert, source, page, *options], check=True, capture_output=True)
    subprocess.run([*convert, source, poses], check=True, capture_output=True)
    with open(poses, encoding="utf-8") as file:
        rows = [list(map(float, line.split(","))) for line in file.read().split()[1:]]
    return page, mark, rows


def look_at_size(page):
    with open(page, encoding="utf-8") as file:
        whole = file.read()
    data = re.search(r'<script type="application/json" id="flight">(.*?)</script>', whole, re.S).group(1)
    beside = len(whole.encode()) - len(data.encode())
    check("bytes beside the flight's data, at most 1 MB", beside <= 1_000_000, beside)
    check("no < in the data", "<" not in data)
    check("no address in the page but that of SVG", set(re.findall(r"https?://[^\s'\"]+", whole)) == {"http://www.w3.org/2000/svg"})
    told = json.loads(data)
    check("texts unchanged", (told["title"], told["comment"], told["points"][0]["name"]) == (TITLE, COMMENT, NAME))


def look_at_marks(browser, rows, mark, what):
    box = browser.run("return vides.picture()")
    check(f"{what}: as many poses", browser.run("return vides.count") == len(rows), len(rows))
    for pose in (1, len(rows) // 2, len(rows)):
        browser.run("vides.seek(arguments[0])", pose)
        browser.settle()
        wanted = projected(rows[pose - 1], mark, box["width"], box["height"])
        told = browser.run("return vides.project(...arguments[0])", mark)
        off = math.dist(wanted, (told["x"], told["y"]))
        drawn = math.dist(wanted, marked(browser, box, wanted))
        check(f"{what}: pose {pose}, mark off by pixels, told and drawn", off < 0.05 and drawn < 1, f"{off:.4f} {drawn:.3f}")


def look_at_texts(browser):
    seen = browser.run("""return {title: document.title, heading: document.getElementById('title').textContent,
        comment: document.getElementById('comment').textContent, scripts: document.scripts.length,
        strangers: document.querySelectorAll('img, b b, i').length, speed: document.getElementById('speed').textContent}""")
    # A document's title has its white space collapsed.
    check("hostile title as text", seen["title"] == seen["heading"] == TITLE)
    check("hostile comment as text", seen["comment"] == COMMENT)
    check("no element of theirs", (seen["scripts"], seen["strangers"]) == (2, 0))
    check("unit as text", seen["speed"].endswith("m<b>/s"), seen["speed"])


def look_at_playing(browser, last):
    at = lambda: browser.run("return vides.pose().frame")
    browser.run("document.activeElement.blur()")
    browser.keys("\ue011")  # Home
    first = browser.picture()
    check("Home is the first frame", at() == 101)
    browser.keys(" ")
    time.sleep(1)
    browser.keys(" ")
    check("space plays and pauses", 106 <= at() <= 160 and not browser.run("return vides.playing"), at())
    check("pixels change", first != browser.picture())
    before = at()
    browser.keys("\ue014", "\ue014", "\ue012")  # right, right, left
    check("arrows scrub", at() == before + 1)
    browser.keys("\ue010")  # End
    check("End is the last frame", at() == 100 + last)
    browser.keys(",")
    check("comma: the support point before", 101 < at() < 100 + last, at())
    box = browser.run("const b = document.getElementById('graph').getBoundingClientRect(); return {x: b.x, y: b.y, width: b.width, height: b.height}")
    middle = box["y"] + box["height"] / 2
    browser.drag((box["x"] + 40, middle), (box["x"] + box["width"] / 2, middle))
    check("dragging in the graph scrubs", abs(at() - (101 + (last - 1) / 2)) <= 1, at())
    space = browser.run("const b = document.getElementById('space').getBoundingClientRect(); return {x: b.x, y: b.y, width: b.width, height: b.height}")
    # Without the ring of the focus.
    crop = lambda: browser.picture(space["x"] + 8, space["y"] + 8, space["width"] - 16, space["height"] - 16)
    still = crop()
    browser.drag((space["x"] + 100, space["y"] + 200), (space["x"] + 180, space["y"] + 200))
    check("dragging turns the space", still != crop())
    browser.run("document.getElementById('space').focus()")
    browser.keys("0")
    check("0 turns it back", still == crop())
    browser.keys("\ue012")
    check("arrows turn the space", still != crop())


def look_at_keyboard(browser):
    browser.run("document.activeElement.blur()")
    stops, seen = [], []
    for _ in range(20):
        browser.keys("\ue004")  # Tab
        name, outline = browser.run("""const e = document.activeElement;
            return [e.id || e.dataset.pane + '-alone', getComputedStyle(e).outlineStyle]""")
        if name not in stops and name != "undefined-alone":
            stops.append(name)
            seen.append(outline != "none" or name == "scrub")
    check("Tab reaches all", {"notes", "language", "theme", "help", "space", "play", "loop", "rate", "scrub", "space-alone", "camera-alone"} <= set(stops), stops)
    # The bar's thumb has no style that a script can read: its pixels tell.
    browser.run("document.getElementById('play').focus()")
    box = browser.run("const b = document.getElementById('scrub').getBoundingClientRect(); return {x: b.x, y: b.y, width: b.width, height: b.height}")
    elsewhere = browser.picture(**box)
    browser.keys("\ue004", "\ue004", "\ue004")  # play, loop, rate, scrub
    there = browser.run("return document.activeElement.id") == "scrub"
    check("the focus is seen", all(seen) and there and elsewhere != browser.picture(**box), seen)
    browser.run("document.activeElement.blur()")
    for key, shown in (("?", "help-window"), ("n", "notes-window")):
        browser.keys(key)
        opened = browser.run("return document.getElementById(arguments[0]).open", shown)
        browser.keys("\ue00c")  # Escape
        check(f"{key} opens, Escape closes", opened and not browser.run("return document.getElementById(arguments[0]).open", shown))


def look_at_themes(browser):
    ground = lambda: browser.run("return getComputedStyle(document.body).backgroundColor")
    box = browser.run("return vides.picture()")
    picture = lambda: decode(browser.picture(box["left"] + 4, box["top"] + 4, 1, 1))[0][0]
    seen = []
    for scheme in ("light", "dark"):
        browser.media(prefers_color_scheme=scheme)
        browser.settle()
        seen.append((ground(), picture()))
    check("light and dark as the system says", seen[0][0] != seen[1][0] and sum(seen[0][1]) > 600 and sum(seen[1][1]) < 150, seen)
    browser.keys("t")
    check("and by the switch", (ground(), picture()) == seen[0])


def look_at_languages(browser, address, other):
    read = "return [document.documentElement.lang, document.querySelector('#space h2').textContent, document.getElementById('play').title]"
    english = browser.run(read)
    check("English", english == ["en", "Space", "Play (space)"], english)
    browser.keys("g")
    german = browser.run(read)
    check("German by the switch", german == ["de", "Raum", "Abspielen (Leertaste)"], german)
    other.open(address)
    other.settle()
    check("German by the browser's language", other.run(read) == german)
    check("numbers too", "," in other.run("return document.getElementById('lens').textContent"))


def look_at_less_motion(browser):
    browser.media(prefers_reduced_motion="reduce")
    browser.run("vides.seek(1)")
    browser.keys(" ")
    seen = set()
    end = time.monotonic() + 2.6
    while time.monotonic() < end:
        seen.add(browser.run("return document.getElementById('frame').textContent"))
    browser.keys(" ")
    check("less motion: a picture a second", {"101", "126"} <= seen <= {"101", "126", "151", "176"}, sorted(seen))
    check("and a choice", not browser.run("return document.getElementById('smooth-row').hidden"))
    browser.media(prefers_reduced_motion="no-preference")


def look_at_loss(browser):
    """The graphics card goes away and comes back."""
    browser.run("vides.seek(10)")
    browser.settle()
    stage = browser.run("const b = document.getElementById('stage').getBoundingClientRect(); return {x: b.x, y: b.y, width: b.width, height: b.height}")
    before = browser.picture(**stage)
    browser.run("window.lost = document.getElementById('scene').getContext('webgl2').getExtension('WEBGL_lose_context'); lost.loseContext()")
    time.sleep(0.3)
    browser.run("lost.restoreContext()")
    time.sleep(0.5)
    browser.settle()
    check("pictures after a lost context", before == browser.picture(**stage))


def look_at_requests(browser, server, pages, file):
    asked = set(server.asked_paths())
    check("the server was asked for the pages alone", asked <= pages, asked)
    sent = set()
    for entry in browser.log("performance"):
        message = json.loads(entry["message"])["message"]
        # The browser's own first page asks for parts of the browser.
        if message["method"] == "Network.requestWillBeSent" and not message["params"]["documentURL"].startswith("chrome:"):
            sent.add(message["params"]["request"]["url"])
    strange = {url for url in sent if not url.startswith((server.address, "data:")) and url != file}
    check("no request to anywhere", {server.address + page for page in pages} <= sent and not strange, len(sent), *strange)


def main():
    convert = sys.argv[1:] or sys.exit("usage: page.py CONVERT...")
    folder = tempfile.mkdtemp()
    page, mark, rows = written(convert, folder, "flight")
    far, far_mark, far_rows = written(convert, folder, "far", up="z", centre=(4e5, -5.5e6, 30))
    look_at_size(page)
    with open(page, encoding="utf-8") as file, open(os.path.join(folder, "cut.html"), "w", encoding="utf-8") as cut:
        cut.write(file.read()[:-200])
    server = Server(folder)
    server.asked_paths = lambda: (re.sub(r"\?.*", "", path) for path in server.asked)
    browser, other = Browser("--lang=en-US", "--accept-lang=en-US"), Browser("--lang=de-DE", "--accept-lang=de-DE")
    try:
        browser.size(1200, 800)
        browser.media(prefers_color_scheme="light")
        browser.open(server.address + "/flight.html")
        browser.settle()
        look_at_texts(browser)
        look_at_marks(browser, rows, mark, "y up")
        look_at_playing(browser, len(rows))
        look_at_keyboard(browser)
        look_at_themes(browser)
        look_at_languages(browser, server.address + "/flight.html", other)
        look_at_less_motion(browser)
        look_at_loss(browser)
        for width, height in ((800, 600), (400, 800), (320, 480)):
            browser.size(width, height)
            over = browser.run("return [document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
            box = browser.run("return vides.picture()")
            check(f"{width}x{height}: nothing over the edge", over[0] <= width and over[1] <= height and box["height"] > 60, over)
        browser.size(1200, 800)
        browser.open(server.address + "/far.html")
        browser.settle()
        look_at_marks(browser, far_rows, far_mark, "z up, far away")
        browser.open("file://" + page)
        browser.settle()
        check("from a file", browser.run("return vides.count") == len(rows))
        look_at_marks(browser, rows, mark, "from a file")
        for kind, driven in (("English", browser), ("German", other)):
            words = [entry["message"] for entry in driven.log("browser")]
            check(f"no word on the console, {kind}", not words, *words)
        browser.open(server.address + "/cut.html")
        browser.settle()
        check("a file cut short says so", "incomplete" in browser.run("return document.getElementById('refusal').textContent"))
        sent = {"/flight.html", "/far.html", "/cut.html"}
        look_at_requests(browser, server, sent, "file://" + page)
    finally:
        browser.close()
        other.close()
        shutil.rmtree(folder)
    print("page.py: all holds")


main()
