"""Requests that no browser sends, to the server of `./course view`: server_attacks.py ADDRESS

Each one gets an error or no answer, and meanwhile the page is answered at once.
"""
import re
import socket
import sys
import time

address = sys.argv[1]
host, port, start = re.fullmatch(r"http://([^:/]+):(\d+)(/\w+/)", address).groups()
failed = False


def fail(what):
    global failed
    print("FAILED:", what)
    failed = True


def connect():
    return socket.create_connection((host, int(port)), timeout=10)


def answer(*pieces):
    """All that is received after the pieces are sent, until the server ends the connection."""
    received = b""
    with connect() as connection:
        try:
            for piece in pieces:
                connection.sendall(piece if isinstance(piece, bytes) else piece.encode())
            while piece := connection.recv(65536):
                received += piece
        except ConnectionError:
            pass
    return received


def status(received):
    return int(received[9:12]) if received else None


def request(path=start, method="GET", version="HTTP/1.1", name=f"127.0.0.1:{port}", rest=""):
    return f"{method} {path} {version}\r\nHost: {name}\r\n{rest}\r\n"


def is_answered_at_once(after):
    before = time.monotonic()
    if status(answer(request())) != 200 or time.monotonic() - before > 3:  # not after the 10 s of a slow reader
        fail(f"the page is answered at once after {after}")


refused = {
    "a path without a slash": (400, request("x")),
    "an absolute address": (400, request(f"http://127.0.0.1:{port}{start}")),
    "an asterisk": (400, request("*", "OPTIONS")),
    "another version": (400, request(version="HTTP/2.0")),
    "no version": (400, f"GET {start}\r\n\r\n"),
    "OPTIONS, before a request of another origin": (405, request(method="OPTIONS")),
    "HEAD": (405, request(method="HEAD")),
    "CONNECT": (400, request("example.org:443", "CONNECT")),
    "a method in small letters": (405, request(method="get")),
    "a form of another origin": (405, request(method="POST", rest="Origin: http://example.org\r\n"
                                              "Content-Length: 3\r\n") + "a=b"),
    "a body in chunks": (405, request(method="POST", rest="Transfer-Encoding: chunked\r\n")
                         + "ffffffff\r\n"),
    "a host name that now leads here": (403, request(name=f"rebound.example.org:{port}")),
    "a host with a user": (403, request(name=f"x@127.0.0.1:{port}")),
    "another name of this machine": (403, request(name=f"127.1:{port}")),
    "a host with a dot": (403, request(name=f"localhost.:{port}")),
    "two hosts": (400, request(rest="Host: example.org\r\n")),
    "a folded host": (400, f"GET {start} HTTP/1.1\r\nX: 1\r\n Host: 127.0.0.1:{port}\r\n\r\n"),
    "half of the secret": (403, request(start[:17] + "/")),
    "the secret in capital letters": (403, request(start.upper() + "x")),
    "the secret, encoded": (403, request("/%" + start[1:])),
    "the secret as a parameter": (403, request("/?" + start)),
    "an encoded path to a file": (404, request(start + "%2e%2e%2f%2e%2e%2fetc%2fpasswd")),
    "a path to a file": (404, request(start + "../../../../../../etc/passwd")),
    "a path to a file, by the other slash": (404, request(start + "..\\..\\page.css")),
    "an encoded zero byte": (404, request(start + "page.css%00.html")),
    "a zero byte": (400, request(start + "page.css\0.html")),
    "a zero byte in a header": (400, request(rest="X: \0\r\n")),
    "a control character": (400, request(start + "\x1b[31m")),
    "a huge number": (400, request(start + "picture?stage=" + "9" * 4000)),
    "a hexadecimal number": (400, request(start + "picture?stage=0x5")),
    "no number": (400, request(start + "picture?stage=nan")),
    "a thousand headers": (431, request(rest="X: 1\r\n" * 2000)),
    "a header without end": (431, b"GET / HTTP/1.1\r\nX: " + b"a" * 9000),
    "TLS": (431, b"\x16\x03\x01" + b"\xff" * 9000),
}
for what, (expected, sent) in refused.items():
    got = answer(sent)
    if status(got) != expected:
        fail(f"{what}: {expected}, not {got[:200]!r}")
    if any(words in got for words in (b"root:", b"Access-Control", start[1:-1].encode())):
        fail(f"{what}: it says more than it may")

two = answer(request(start + "none") + request())
if status(two) != 404 or two.count(b"HTTP/1.1 ") != 1:
    fail("of two requests at a time the first alone is answered")
if status(answer(*request())) != 200:
    fail("a request in pieces of a byte is answered")

# Connections that send nothing, that send half a request, and that end their half at once.
slow = [connect() for _ in range(300)]
for i, connection in enumerate(slow):
    if i % 3 == 1:
        connection.sendall(b"GET / HTTP/1.1\r\n")
    if i % 3 == 2:
        connection.shutdown(socket.SHUT_WR)
is_answered_at_once("connections without a request")
for _ in range(200):
    connect().close()
is_answered_at_once("connections that are closed at once")
began = time.monotonic()
if status(slow[-2].recv(100)) != 408 or not 3 < time.monotonic() - began < 7:
    fail("a slow connection is ended after 5 s")

# Connections that request a large answer (view_test.sh makes it large), and read nothing of it.
readers = []
for _ in range(24):
    reader = socket.socket()
    reader.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1024)
    reader.connect((host, int(port)))
    reader.sendall(request(start + "difference.js").encode())
    readers.append(reader)
time.sleep(0.5)
is_answered_at_once("connections that do not read their answers")
for reader in readers:
    reader.close()
sys.exit(failed)
