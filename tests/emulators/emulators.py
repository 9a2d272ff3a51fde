"""Controllers and an extruder in software, for exported senders (Python 3, standard library).

python3 emulators.py KIND FOLDER [FAULT]

KIND: datalink, eki, mxt, urscript or castelli. FOLDER has the exported files. The sender runs
against the emulator on the loopback. Prints "taken N" and ends with 0 if all lines came in their
order; prints what was wrong and ends with 1 otherwise. FAULT makes the emulator misbehave: close
(after some lines), silent (answers stop).
"""
import glob
import os
import re
import socket
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as ElementTree

HOST, LONGEST_S = "127.0.0.1", 60


class Wrong(Exception):
    pass


def only(folder, pattern):
    found = glob.glob(os.path.join(folder, pattern))
    if len(found) != 1:
        raise Wrong("not one file %s: %d" % (pattern, len(found)))
    return found[0]


def numbers_of(path):
    """The rows of numbers in a file of lines, as tuples."""
    rows = []
    with open(path, encoding="ascii") as stream:
        for line in stream:
            fields = line.split("#")[0].strip().split(",")
            try:
                rows.append(tuple(float(field) for field in fields))
            except ValueError:
                pass  # a head: words and names
    return rows


def run_sender(arguments):
    return subprocess.Popen([sys.executable] + arguments, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)


def end_of(sender):
    try:
        said, _ = sender.communicate(timeout=LONGEST_S)
    except subprocess.TimeoutExpired:
        sender.kill()
        raise Wrong("the sender does not end")
    if sender.returncode != 0:
        raise Wrong("the sender gave up: " + said.strip().splitlines()[-1])


def expect_rows(taken, wanted):
    for i, (one, other) in enumerate(zip(taken, wanted)):
        if one != other:
            raise Wrong("line %d is %s instead of %s" % (i + 1, one, other))
    if len(taken) != len(wanted):
        raise Wrong("%d lines instead of %d" % (len(taken), len(wanted)))


class Served(threading.Thread):
    """A controller that serves one connection; what it finds wrong ends up in `error`."""

    def __init__(self, fault):
        super().__init__(daemon=True)
        self.fault, self.error, self.taken = fault, None, []
        self.server = socket.create_server((HOST, 0))
        self.server.settimeout(LONGEST_S)
        self.port = self.server.getsockname()[1]

    def run(self):
        try:
            link, _ = self.server.accept()
            with link:
                link.settimeout(LONGEST_S)
                self.serve(link)
        except (Wrong, OSError, ValueError, ElementTree.ParseError) as error:
            self.error = error
        finally:
            self.server.close()

    def is_broken(self):
        return self.fault and len(self.taken) >= 40

    def result(self, sender=None):
        """Waits for both; what the controller found comes first."""
        gave_up = None
        try:
            if sender:
                end_of(sender)
        except Wrong as why:
            gave_up = why
        self.join(1 if gave_up else LONGEST_S)
        if self.error:
            raise Wrong("the controller: %s" % self.error)
        if gave_up:
            raise gave_up

    def break_down(self, link):
        """Closes the connection, or stays silent, and takes what still comes."""
        if self.fault == "close":
            link.shutdown(socket.SHUT_WR)
        try:
            while link.recv(1024):
                pass
        except OSError:
            pass


class DataLink(Served):
    """The data link of a MELFA controller: Input # takes a line that ends with CR, Print # answers.

    It stores a few lines only, in whole packets: what comes while the store is full is lost.
    """
    STORED = 32

    def serve(self, link):
        text = b""
        while True:
            if not self.taken:
                time.sleep(0.5)  # the way to the first line
            more = link.recv(65536)
            if not more:
                raise Wrong("closed by the sender after line %d" % len(self.taken))
            text += more
            if text.count(b"\r") > self.STORED:
                raise Wrong("%d lines at once are too many" % text.count(b"\r"))
            if b"\n" in text:
                raise Wrong("a line feed in a line")
            while b"\r" in text:
                line, text = text.split(b"\r", 1)
                values = tuple(float(field) for field in line.split(b","))
                if len(values) != 9:
                    raise Wrong("%d values for nine variables" % len(values))
                self.taken.append(values)
                if self.is_broken():
                    return self.break_down(link)
                link.sendall(b"%g\r" % values[6])
                if values[6] == 0:  # M7=0: the end
                    link.settimeout(0.2)
                    try:
                        if link.recv(1):
                            raise Wrong("a line behind the last one")
                    except socket.timeout:
                        pass
                    return None


class Eki(Served):
    """A channel of KUKA.EthernetKRL as its XML file sets it up, and the loop of the program."""

    def __init__(self, fault, channel):
        super().__init__(fault)
        root = ElementTree.parse(channel).getroot()
        self.limit = int(root.find("CONFIGURATION/INTERNAL/BUFFERING").get("Limit"))
        self.most_bytes = int(root.find("CONFIGURATION/INTERNAL/BUFFSIZE").get("Limit"))
        self.names = [element.get("Tag").split("/@")[1]
                      for element in root.findall("RECEIVE/XML/ELEMENT")]

    def serve(self, link):
        text, untold = "", 0
        while True:
            more = link.recv(1024)
            if not more:
                raise Wrong("closed by the sender after record %d" % len(self.taken))
            text += more.decode("ascii")
            if text.count("/>") > self.limit or len(text) > self.most_bytes:
                raise Wrong("the buffer overflows")  # EKI closes the connection
            while "/>" in text:
                record, text = text.split("/>", 1)
                element = ElementTree.fromstring(record.strip() + "/>")
                if element.tag != "L" or list(element.keys()) != self.names:
                    raise Wrong("not a record of the channel: " + record.strip())
                values = tuple(float(element.get(name)) for name in self.names)
                self.taken.append(values)
                if self.is_broken():
                    return self.break_down(link)
                untold += 1
                is_last = values[self.names.index("V")] == 0
                if is_last or untold == 8:
                    untold = 0
                    link.sendall(b'<Taken N="%d"/>' % len(self.taken))
                if is_last:
                    return None


def datalink(folder, fault):
    lines = only(folder, "*.lines")
    controller = DataLink(fault)
    controller.start()
    controller.result(
        run_sender([only(folder, "*_link.py"), lines, HOST, str(controller.port)]))
    expect_rows(controller.taken, numbers_of(lines))
    return len(controller.taken)


def eki(folder, fault):
    lines = only(folder, "*.eki")
    controller = Eki(fault, only(folder, "*_eki.xml"))
    controller.start()
    controller.result(run_sender([only(folder, "*_eki.py"), lines, HOST, str(controller.port)]))
    expect_rows(controller.taken, numbers_of(lines))
    return len(controller.taken)


def mxt(folder, fault):
    """Mxt: one packet a cycle, each answered once the program has come to Mxt."""
    port, size, last = 10000, 196, b"\xff\x00"
    host = "127.0.0.7"
    with open(only(folder, "*.mxt"), "rb") as stream:
        data = stream.read()
    wanted = [data[i:i + size] for i in range(0, len(data), size)]
    taken = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as controller:
        controller.bind((host, port))
        controller.settimeout(LONGEST_S)
        sender = run_sender([only(folder, "*_mxt.py"), only(folder, "*.mxt"), host])
        for _ in range(2):  # the operator has not started the program yet
            packet, _ = controller.recvfrom(1024)
            if packet != wanted[0]:
                raise Wrong("the first packet is another one")
        while not taken or taken[-1][:2] != last:
            packet, peer = controller.recvfrom(1024)
            if len(packet) != size:
                raise Wrong("a packet of %d bytes" % len(packet))
            taken.append(packet)
            if fault and len(taken) == 40:
                break
            controller.sendto(packet, peer)
        end_of(sender)
    expect_rows(taken, wanted)
    return len(taken)


def urscript(folder, fault):
    """Port 30002 takes the receiver, which calls back and reads rows as the manual says of
    socket_read_ascii_float: numbers in parentheses."""
    rows_file = only(folder, "*.joints")
    with socket.create_server((HOST, 30002)) as server:
        server.settimeout(LONGEST_S)
        sender = run_sender([only(folder, "*_sender.py"), rows_file,
                             only(folder, "*_receiver.script"), HOST])
        robot, _ = server.accept()
        with robot:
            robot.settimeout(LONGEST_S)
            robot.sendall(bytes(79))
            program = ""
            while not program.endswith("\nend\n"):
                program += robot.recv(4096).decode("ascii")
    call = re.search(r'socket_open\("([0-9.]+)",([0-9]+),"rows"\)', program)
    if not call or "SENDER_ADDRESS" in program:
        raise Wrong("the receiver has no address to call")
    taken, text = [], ""
    with socket.create_connection((call[1], int(call[2])), LONGEST_S) as link:
        while not taken or taken[-1][0] > 0.5:
            while ")" not in text:
                more = link.recv(256).decode("ascii")
                if not more:
                    raise Wrong("the rows end without their end")
                text += more
            row, text = text.split(")", 1)
            values = tuple(float(field) for field in row.strip().lstrip("(").split(","))
            if len(values) != 10:
                raise Wrong("a row of %d numbers" % len(values))
            taken.append(values)
            if fault and len(taken) == 40:
                break
    end_of(sender)
    expect_rows(taken, numbers_of(rows_file))
    return len(taken)


class Board(Served):
    """The extruder's board: texts that end with n, at most 16 bytes each."""

    def serve(self, link):
        text, heated = "", False
        while True:
            more = link.recv(64).decode("ascii")
            if not more:
                break
            text += more
            while "n" in text:
                command, text = text.split("n", 1)
                if not re.fullmatch(r"(G-?|[MTFR])[0-9]+", command) or len(command) > 15:
                    raise Wrong("not a command: " + command)
                heated = int(command[1:]) > 0 if command[0] == "M" else heated
                if command[0] == "G" and command != "G0" and not heated:
                    raise Wrong("the motor turns before the nozzle is hot")
                self.taken.append(command)
        if text:
            raise Wrong("a text without its end: " + text)
        if heated:
            raise Wrong("the nozzle stays hot")
        if [c for c in self.taken if c[0] == "G"][-1] != "G0":
            raise Wrong("the motor runs on")


def castelli(folder, fault):
    """The program's own socket statements, in their order, to the board."""
    board = Board(fault)
    board.start()
    link, sent = None, 0
    with open(only(folder, "*.script"), encoding="ascii") as stream:
        for line in stream:
            code = line.split("#")[0].strip()
            if code.startswith("socket_open("):
                link = socket.create_connection((HOST, board.port), LONGEST_S)
            text = re.fullmatch(r'socket_send_string\("([^"]*)","[^"]*"\)', code)
            if text:
                if not link:
                    raise Wrong("a text before the socket is open")
                link.sendall(text[1].encode("ascii"))
                sent += 1
            if code.startswith("socket_close("):
                link.close()
    board.result()
    if len(board.taken) != sent:
        raise Wrong("%d commands of %d" % (len(board.taken), sent))
    return sent


KINDS = {"datalink": datalink, "eki": eki, "mxt": mxt, "urscript": urscript, "castelli": castelli}

if __name__ == "__main__":
    try:
        print("taken", KINDS[sys.argv[1]](sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else None))
    except (Wrong, OSError) as why:
        sys.exit(str(why))
