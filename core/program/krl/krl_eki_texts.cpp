#include "program/krl/krl_eki_texts.h"

#include "program/common/program_text.h"

namespace voluta::program {

namespace {

// Records are buffered in the controller: enough to feed its advance run, and far fewer than the
// number at which EKI closes the connection.
constexpr std::string_view kSender = R"py(#!/usr/bin/env python3
"""Sends the lines of a print to a KUKA controller by KUKA.EthernetKRL (EKI).

python3 NAME_eki.py NAME.eki ADDRESS_OF_THE_CONTROLLER [PORT]

The controller listens once its program has come to EKI_Open, and tells now and then how many lines
it has taken.
"""
import re
import socket
import sys
import time

PORT, AHEAD, START_S, ANSWER_S = 54600, 128, 600, 600
NAMES = "XYZABCVWFD"
TAKEN = re.compile(r'<Taken\s+N="([0-9]+)')


def records(path):
    with open(path, encoding="ascii") as stream:
        for line in stream:
            line = "".join(line.split("#")[0].split())
            if line[:1] in tuple("-0123456789"):
                numbers = line.split(",")
                if len(numbers) != len(NAMES):
                    sys.exit("not a line of a print: " + line)
                fields = " ".join('%s="%s"' % pair for pair in zip(NAMES, numbers))
                yield "<L " + fields + "/>\r\n"


def connected(robot, port):
    end = time.monotonic() + START_S  # an operator starts the program meanwhile
    while True:
        try:
            return socket.create_connection((robot, port), 10)
        except OSError:
            if time.monotonic() > end:
                sys.exit("nobody listens: is the program at EKI_Open?")
            time.sleep(1)


class Answers:
    def __init__(self, link):
        self.link, self.text, self.taken = link, "", 0

    def wait(self):
        more = self.link.recv(4096)
        if not more:
            sys.exit("the controller has closed the link")
        self.text += more.decode("ascii", "replace")
        answers = self.text.split(">")  # the last is not whole yet
        for answer in answers[:-1]:
            taken = TAKEN.search(answer)
            if taken:
                self.taken = int(taken[1])
        self.text = answers[-1]


def main(path, robot, port=PORT):
    with connected(robot, int(port)) as link:
        link.settimeout(ANSWER_S)
        answers, sent = Answers(link), 0
        for record in records(path):
            while sent - answers.taken >= AHEAD:
                answers.wait()
            link.sendall(record.encode("ascii"))
            sent += 1
        while answers.taken < sent:
            answers.wait()


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
)py";

constexpr std::string_view kChannel = R"(<ETHERNETKRL>
  <CONFIGURATION>
    <EXTERNAL>
      <TYPE>Client</TYPE>
    </EXTERNAL>
    <INTERNAL>
      <ENVIRONMENT>Program</ENVIRONMENT>
      <BUFFERING Mode="FIFO" Limit="512"/>
      <BUFFSIZE Limit="65534"/>
      <ALIVE Set_Flag="1"/>
      <IP>192.168.0.40</IP>
      <PORT>54600</PORT>
      <PROTOCOL>TCP</PROTOCOL>
    </INTERNAL>
  </CONFIGURATION>
  <RECEIVE>
    <XML>
      <ELEMENT Tag="L/@X" Type="REAL"/>
      <ELEMENT Tag="L/@Y" Type="REAL"/>
      <ELEMENT Tag="L/@Z" Type="REAL"/>
      <ELEMENT Tag="L/@A" Type="REAL"/>
      <ELEMENT Tag="L/@B" Type="REAL"/>
      <ELEMENT Tag="L/@C" Type="REAL"/>
      <ELEMENT Tag="L/@V" Type="REAL"/>
      <ELEMENT Tag="L/@W" Type="REAL"/>
      <ELEMENT Tag="L/@F" Type="REAL"/>
      <ELEMENT Tag="L/@D" Type="REAL"/>
    </XML>
  </RECEIVE>
  <SEND>
    <XML>
      <ELEMENT Tag="Taken/@N"/>
    </XML>
  </SEND>
</ETHERNETKRL>
)";

// EKI reads only into initialized variables.
constexpr std::string_view kData = R"(DECL FRAME GOAL={X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}
DECL AXIS JOINTS={A1 0.0,A2 0.0,A3 0.0,A4 0.0,A5 0.0,A6 0.0}
DECL REAL PACE=0.0
DECL REAL TURNING=0.0
DECL REAL SHARE=0.0
DECL REAL CORNER=0.0
DECL REAL HELD=0.0
DECL REAL FLOWS[8]
FLOWS[1]=0.0
FLOWS[2]=0.0
FLOWS[3]=0.0
FLOWS[4]=0.0
FLOWS[5]=0.0
FLOWS[6]=0.0
FLOWS[7]=0.0
FLOWS[8]=0.0
DECL INT SLOT=1
DECL INT TAKEN=0
DECL INT UNTOLD=0
DECL BOOL FEEDS=FALSE
)";

// No state of the machine is read, and outputs are assigned only where the arm is at rest: either
// would stop the advance run. Each trigger's value has a separate variable, because it is
// undocumented whether the value is read when the trigger is programmed or when it fires; there are
// always more variables than pending motions and triggers ($ADVANCE).
constexpr std::string_view kBegin = R"(RET=EKI_Init("%")
RET=EKI_Open("%")
WAIT FOR $FLAG[1]
LOOP
REPEAT
RET=EKI_CheckBuffer("%","L/@D")
UNTIL (RET.BUFF>0) OR (RET.CONNECTED==FALSE)
IF RET.BUFF<1 THEN
EXIT
ENDIF
RET=EKI_GetReal("%","L/@X",GOAL.X)
RET=EKI_GetReal("%","L/@Y",GOAL.Y)
RET=EKI_GetReal("%","L/@Z",GOAL.Z)
RET=EKI_GetReal("%","L/@A",GOAL.A)
RET=EKI_GetReal("%","L/@B",GOAL.B)
RET=EKI_GetReal("%","L/@C",GOAL.C)
RET=EKI_GetReal("%","L/@V",PACE)
RET=EKI_GetReal("%","L/@W",TURNING)
RET=EKI_GetReal("%","L/@F",SHARE)
RET=EKI_GetReal("%","L/@D",CORNER)
TAKEN=TAKEN+1
IF PACE==0 THEN
RET=EKI_SetInt("%","Taken/@N",TAKEN)
RET=EKI_Send("%","Taken")
EXIT
ENDIF
IF PACE<0 THEN
$ANOUT[1]=SHARE
IF SHARE>0 THEN
$OUT[1]=TRUE
ENDIF
WAIT SEC -PACE
$OUT[1]=FALSE
FEEDS=FALSE
HELD=SHARE
ELSE
IF CORNER<0 THEN
$OUT[1]=FALSE
$ANOUT[1]=0
FEEDS=FALSE
HELD=0
BAS (#VEL_PTP,PACE)
)";
constexpr std::string_view kToJoints = R"(JOINTS.A1=GOAL.X
JOINTS.A2=GOAL.Y
JOINTS.A3=GOAL.Z
JOINTS.A4=GOAL.A
JOINTS.A5=GOAL.B
JOINTS.A6=GOAL.C
PTP JOINTS
)";
constexpr std::string_view kToPose = R"(PTP GOAL
)";
constexpr std::string_view kRest = R"(ELSE
$VEL.CP=PACE/1000
$VEL.ORI1=TURNING
$VEL.ORI2=TURNING
IF (SHARE>0) AND (FEEDS==FALSE) THEN
$ANOUT[1]=SHARE
$OUT[1]=TRUE
FEEDS=TRUE
HELD=SHARE
ENDIF
IF (SHARE==0) AND (FEEDS==TRUE) THEN
$OUT[1]=FALSE
$ANOUT[1]=0
FEEDS=FALSE
HELD=0
ENDIF
IF SHARE<>HELD THEN
HELD=SHARE
SLOT=SLOT+1
IF SLOT>8 THEN
SLOT=1
ENDIF
FLOWS[SLOT]=SHARE
SWITCH SLOT
CASE 1
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[1]
CASE 2
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[2]
CASE 3
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[3]
CASE 4
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[4]
CASE 5
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[5]
CASE 6
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[6]
CASE 7
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[7]
CASE 8
TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]=FLOWS[8]
ENDSWITCH
ENDIF
IF CORNER>0 THEN
$APO.CDIS=CORNER
LIN GOAL C_DIS
ELSE
LIN GOAL
ENDIF
ENDIF
ENDIF
UNTOLD=UNTOLD+1
IF UNTOLD==8 THEN
UNTOLD=0
RET=EKI_SetInt("%","Taken/@N",TAKEN)
RET=EKI_Send("%","Taken")
ENDIF
ENDLOOP
$OUT[1]=FALSE
$ANOUT[1]=0
RET=EKI_Close("%")
RET=EKI_Clear("%")
END
)";

} // namespace

std::string_view krlEkiSender() {
  return kSender;
}
std::string_view krlEkiChannel() {
  return kChannel;
}
std::string_view krlEkiData() {
  return kData;
}
std::string krlEkiLoop(bool joints) {
  return joined({kBegin, joints ? kToJoints : kToPose, kRest});
}

std::vector<std::string> linesFor(std::string_view text, std::string_view channel) {
  std::vector<std::string> all;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    std::string& last = all.emplace_back(line);
    // The replacement is not searched again: a file's name may itself contain '%'.
    for (std::size_t at = last.find('%'); at != std::string::npos;
         at = last.find('%', at + channel.size()))
      last.replace(at, 1, channel);
  }
  return all;
}

} // namespace voluta::program
