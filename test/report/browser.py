# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A headless Chromium for tests of pages, by the DevTools protocol over a pipe."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PROGRAMS = ["chromium-headless-shell", "chromium", "chromium-browser"]
ANSWER_S = 300.0  # longer than any answer takes on a loaded machine: then the browser is stuck


def browser_program():
    """Returns the path of the browser, or None."""
    return next(filter(None, map(shutil.which, PROGRAMS)), None)


class Browser:
    """One page. `problems` are errors of its console, and what it asked of the network."""

    def __init__(self, width=1280, height=900, options=()):
        self.problems = []
        self._buffer = b""
        self._last_id = 0
        self._profile = tempfile.TemporaryDirectory(prefix="browser_")
        self._start(list(options))
        target = self._call("Target.createTarget", url="about:blank")["targetId"]
        self._session = None
        self._session = self._call("Target.attachToTarget", targetId=target,
                                   flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Log", "Network"]:
            self._call(f"{domain}.enable")
        self.resize(width, height)

    def _start(self, options):
        to_browser, self._to = os.pipe()
        self._from, from_browser = os.pipe()

        def move_pipes():  # the protocol is spoken on descriptors 3 and 4
            spare = [os.dup(to_browser), os.dup(from_browser)]
            os.dup2(spare[0], 3)
            os.dup2(spare[1], 4)
        self._session = None
        self._process = subprocess.Popen(
            [browser_program(), "--headless", "--no-sandbox", "--remote-debugging-pipe",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--hide-scrollbars", "--disable-dev-shm-usage", "--no-first-run",
             f"--user-data-dir={self._profile.name}"] + options,
            pass_fds=[3, 4], preexec_fn=move_pipes, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)

    def close(self):
        self._process.terminate()
        self._process.wait()
        self._profile.cleanup()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _read(self, deadline):
        while b"\0" not in self._buffer:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._from], [], [], left)[0]:
                raise TimeoutError("the browser does not answer")
            data = os.read(self._from, 1 << 20)
            if not data:
                raise ConnectionError("the browser has ended")
            self._buffer += data
        text, self._buffer = self._buffer.split(b"\0", 1)
        return json.loads(text)

    def _note(self, event):
        name, data = event.get("method"), event.get("params", {})
        if name == "Runtime.exceptionThrown":
            self.problems.append(str(data["exceptionDetails"].get("exception", data)))
        elif name == "Runtime.consoleAPICalled" and data["type"] in ("error", "assert"):
            self.problems.append(str(data["args"]))
        elif name == "Log.entryAdded" and data["entry"]["level"] == "error":
            self.problems.append(data["entry"]["text"])
        elif name == "Network.requestWillBeSent":
            url = data["request"]["url"]
            if not url.startswith(("file:", "data:", "about:")):
                self.problems.append(f"asked the network for {url}")

    def _call(self, method, **parameters):
        self._last_id += 1
        message = {"id": self._last_id, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._to, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + ANSWER_S
        while True:
            answer = self._read(deadline)
            if answer.get("id") == self._last_id:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self._note(answer)

    def resize(self, width, height, is_phone=False):
        self._call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                   deviceScaleFactor=1, mobile=is_phone)

    def open(self, path):
        """Opens a file and waits until its first picture is drawn. Returns when that was [ms]."""
        self._call("Page.navigate", url=path.resolve().as_uri())
        return int(self.wait("document.documentElement?.dataset.firstPictureMs"))

    def run(self, script):
        """Returns the value of a JavaScript expression."""
        result = self._call("Runtime.evaluate", expression=script, returnByValue=True,
                            awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{script}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def wait(self, script):
        """Returns the value of an expression as soon as it is true."""
        deadline = time.monotonic() + ANSWER_S
        while time.monotonic() < deadline:
            value = self.run(script)
            if value:
                return value
            time.sleep(0.02)
        raise TimeoutError(f"never true: {script}; problems: {self.problems}")

    def click(self, x, y):
        for kind in ["mousePressed", "mouseReleased"]:
            self._call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                       buttons=1, clickCount=1)

    def key(self, name, code):
        """Presses a key by its name and its Windows code, which sliders listen to."""
        for kind in ["rawKeyDown", "keyUp"]:
            self._call("Input.dispatchKeyEvent", type=kind, key=name, windowsVirtualKeyCode=code)

    def tap(self, x, y):
        """Touches a point with one finger."""
        self._call("Emulation.setTouchEmulationEnabled", enabled=True)
        self._call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self._call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def drag(self, start, end):
        """Drags the mouse from one point to another."""
        for kind, (x, y) in [("mousePressed", start), ("mouseMoved", end), ("mouseReleased", end)]:
            self._call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                       buttons=1, clickCount=1)

    def picture(self, whole=False):
        """Returns a PNG file of what is seen, or of the whole page."""
        self.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        answer = self._call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        return base64.b64decode(answer["data"])
