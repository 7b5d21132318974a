"""Firefox, driven by WebDriver BiDi, as chromium.py; needs Debian's firefox-esr and python3-websocket."""
import json
import os
import pathlib
import shutil
import subprocess
import time

try:
    import websocket
except ImportError:
    websocket = None

program = next(filter(None, map(shutil.which, ["firefox-esr", "firefox"])), None)
missing = "firefox" if program is None else "python3-websocket" if websocket is None else None
keys = {"ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015"}


class Firefox:
    """Firefox, and its answers on a socket of this machine."""

    def __init__(self, folder):
        self.process = subprocess.Popen(
            [program, "--headless", "--no-remote", "--profile", folder, "--remote-debugging-port", "0", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "HOME": folder})
        address = pathlib.Path(folder) / "WebDriverBiDiServer.json"
        for _ in range(1200):
            if address.exists() or self.process.poll() is not None:
                break
            time.sleep(0.05)
        server = json.loads(address.read_text())
        self.socket = websocket.create_connection(f"ws://{server['ws_host']}:{server['ws_port']}/session",
                                                  timeout=120, suppress_origin=True)
        self.number, self.events = 0, []
        self.call("session.new", capabilities={})
        self.page = {"context": self.call("browsingContext.getTree")["contexts"][0]["context"]}
        self.call("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])
        self.call("browsingContext.setViewport", **self.page, viewport={"width": 700, "height": 900})

    def call(self, method, **parameters):
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            answer = json.loads(self.socket.recv())
            if answer.get("id") != self.number:
                self.events.append(answer)
            elif answer["type"] == "error":
                raise RuntimeError(f"{method}: {answer['message']}")
            else:
                return answer["result"]

    def open(self, url):
        self.call("browsingContext.navigate", **self.page, url=url, wait="complete")

    def run(self, script):
        answer = self.call("script.evaluate", target=self.page, awaitPromise=True,
                           expression=f"Promise.resolve({script}).then((value) => JSON.stringify(value))")
        if answer["type"] == "exception":
            raise RuntimeError(answer["exceptionDetails"]["text"])
        return json.loads(answer["result"].get("value", "null"))

    def mouse(self, kind, x, y):
        actions = [{"type": "pointerMove", "x": round(x), "y": round(y)}]
        if kind != "mouseMoved":
            actions.append({"type": "pointerDown" if kind == "mousePressed" else "pointerUp", "button": 0})
        self.call("input.performActions", **self.page, actions=[{"type": "pointer", "id": "mouse", "actions": actions}])

    def key(self, name):
        actions = [{"type": kind, "value": keys[name]} for kind in ["keyDown", "keyUp"]]
        self.call("input.performActions", **self.page, actions=[{"type": "key", "id": "keyboard", "actions": actions}])

    def complaints(self, origin):
        """Errors on the console and requests to other hosts, since events were cleared."""
        errors = []
        for event in self.events:
            parameters = event.get("params", {})
            url = parameters.get("request", {}).get("url", origin)
            if not url.startswith((origin, "data:")):
                errors.append(f"a request to {url}")
            if event.get("method") == "log.entryAdded" and parameters["level"] == "error":
                errors.append(f"error: {parameters['text'][:400]}")
        return errors
