"""What comes of the calls of python/robosim after an interrupt or a timeout; PythonInterruptsTest runs it.

The module here is a stand-in that answers each sonar with its own xOffset, so that an answer to another call is noticed.
"""

import json
import random
import signal
import socket
import sys
import threading
import time

import robosim

CONNECT_AGAIN = "cannot be used any more; connect again"


class StandIn(threading.Thread):
    """Answers requests after a while, in pieces, until the peer hangs up."""

    def __init__(self, sock, delay):
        super().__init__(daemon=True)
        self.sock, self.delay, self.lines = sock, delay, sock.makefile("rb")

    def run(self):
        try:
            for line in self.lines:
                request = json.loads(line)
                if request["type"] == "hello":
                    answer = {"type": "hello", "version": 1, "module": "a stand-in", "limits": {}}
                else:
                    answer = {"type": "distances", "id": request.get("id"),
                              "distances": [each["xOffset"] for each in request["requests"]]}
                    time.sleep(self.delay())
                text = json.dumps(answer).encode() + b"\n"
                self.sock.sendall(text[:7])
                if answer["type"] == "distances":
                    time.sleep(self.delay())
                self.sock.sendall(text[7:])
        except OSError:
            pass
        finally:
            self.lines.close()
            self.sock.close()


def module(delay=lambda: 0.0, timeout=None):
    ours, theirs = socket.socketpair()
    ours.settimeout(timeout)
    StandIn(theirs, delay).start()
    return robosim.Module(ours)



def interrupted_at(number, what):
    """Does something, with an interrupt before the line of client.py that is the so-manieth; whether it came to that."""
    left = [number]

    def trace(frame, event, _):
        if not frame.f_code.co_filename.endswith("robosim/client.py"):
            return None
        if event == "line":
            left[0] -= 1
            if left[0] == 0:
                raise KeyboardInterrupt
        return trace

    sys.settrace(trace)
    try:
        what()
    except KeyboardInterrupt:
        pass
    finally:
        sys.settrace(None)
    return left[0] <= 0


def everywhere(what):
    """An interrupt before each line of a call in turn; the share of them after which the connection can go on."""
    number = good = 0
    while True:
        number += 1
        one = module()
        if not interrupted_at(number, lambda: what(one)):
            assert number > 20, number
            one.close()
            return good / (number - 1)
        try:
            for k in (7.0, 8.0, 9.0):
                assert one.sonar("r", k) == k, (number, k)
            good += 1
        except robosim.NotDone as e:
            assert CONNECT_AGAIN in str(e), e
        one.close()


def ahead(one):
    asked = {"type": "sonars", "requests": [{"objectName": "r", "xOffset": 3.0, "zOffset": 0}]}
    one.send(asked)
    assert one.sonar("r", 4.0) == 4.0
    assert one.receive("distances")["distances"] == [3.0]


def by_signals(count):
    """Interrupts of real calls by a clock, at any moment."""
    rng = random.Random(20261126)
    refused = wrong = interrupted = 0

    def ring(*_):
        raise KeyboardInterrupt

    signal.signal(signal.SIGALRM, ring)
    one = module(lambda: rng.random() * 0.001)
    for k in range(count):
        try:
            signal.setitimer(signal.ITIMER_REAL, 1e-5 + rng.random() * 0.002)
            one.sonar("r", k + 0.5)
            signal.setitimer(signal.ITIMER_REAL, 0)
        except KeyboardInterrupt:
            interrupted += 1
        except robosim.NotDone:
            refused += 1
            signal.setitimer(signal.ITIMER_REAL, 0)
            one.close()
            one = module(lambda: rng.random() * 0.001)
        signal.setitimer(signal.ITIMER_REAL, 0)
        try:
            wrong += one.sonar("r", -k - 1.0) != -k - 1.0
        except robosim.NotDone as e:
            assert CONNECT_AGAIN in str(e), e
            refused += 1
            one.close()
            one = module(lambda: rng.random() * 0.001)
    one.close()
    assert wrong == 0, wrong
    return interrupted, refused


def late():
    """An answer that comes after the timeout is dropped."""
    pauses = [0.0, 0.6, 0.6, 0.0, 0.0]
    one = module(lambda: pauses.pop(0) if pauses else 0.0, timeout=0.3)
    try:
        one.sonar("r", 1.0)
        one.sonar("r", 2.0)
        raise AssertionError("that took too long")
    except robosim.NotDone as e:
        assert "no answer came within 0.3 s" in str(e), e
    one._sock.settimeout(20)
    assert one.sonar("r", 3.0) == 3.0
    one.close()
    begin = time.monotonic()
    try:
        robosim.accept(0, timeout=0.2)
        raise AssertionError("nobody connects")
    except robosim.NotDone as e:
        assert "no module connected to port 0 within 0.2 s" in str(e), e
    assert time.monotonic() - begin < 20


def main():
    real = socket.socket.setsockopt
    socket.socket.setsockopt = lambda self, *_: None if self.family == socket.AF_UNIX else real(self, *_)
    shares = [everywhere(lambda one: one.sonar("r", 1.0)), everywhere(ahead)]
    assert all(0.5 < share < 1 for share in shares), shares
    interrupted, refused = by_signals(300)
    assert 100 < interrupted, interrupted
    assert refused < interrupted / 3, (interrupted, refused)
    late()
    print("all done")


main()
