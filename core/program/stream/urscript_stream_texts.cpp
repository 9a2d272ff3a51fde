#include "program/stream/urscript_stream_texts.h"

namespace voluta::program {

namespace {

// The socket's buffer of rows serves as the queue. Times accumulate: the remainder of a row's last
// cycle is part of the next row. lookahead_time and gain are the manual's minimum and middle.
constexpr std::string_view kReceiver = R"(  # from here on the same for every job
  def between(a, b, share):
    return [a[0]+(b[0]-a[0])*share,a[1]+(b[1]-a[1])*share,a[2]+(b[2]-a[2])*share,a[3]+(b[3]-a[3])*share,a[4]+(b[4]-a[4])*share,a[5]+(b[5]-a[5])*share]
  end
  set_analog_outputdomain(0,1) # 0 to 10 V
  set_standard_digital_out(0,False)
  set_standard_analog_out(0,0)
  popup("The arm goes slowly and straight to its start. Is the way clear?",title="Voluta",blocking=True)
  here = get_actual_joint_positions()
  step = get_steptime()
  into = 0
  going = socket_open("SENDER_ADDRESS",50012,"rows")
  while going:
    row = socket_read_ascii_float(10,"rows",2)
    # nothing for two seconds, no row, or the end
    if row[0] != 10:
      going = False
    elif row[1] < 0.5:
      going = False
    else:
      there = [row[3],row[4],row[5],row[6],row[7],row[8]]
      set_standard_analog_out(0,row[10])
      set_standard_digital_out(0,row[9] > 0.5)
      if row[1] < 1.5:
        movej(there,a=0.5,v=0.25)
        into = 0
      else:
        while into + step <= row[2]:
          into = into + step
          servoj(between(here,there,into/row[2]),t=step,lookahead_time=0.03,gain=1000)
        end
        into = into - row[2]
      end
      here = there
    end
  end
  stopj(2)
  set_standard_digital_out(0,False)
  set_standard_analog_out(0,0)
  socket_close("rows")
end
)";

constexpr std::string_view kSender = R"(#!/usr/bin/env python3
"""Sends a stream of joints to a Universal Robots controller.

python3 NAME_sender.py NAME.joints NAME_receiver.script ADDRESS_OF_THE_ROBOT

The receiver goes to the robot's port 30002 and calls back for the rows.
"""
import socket
import sys

ROBOT_PORT, ROWS_PORT, CALL_BACK_S = 30002, 50012, 300


def rows(path):
    with open(path, encoding="ascii") as stream:
        for line in stream:
            row = line.split("#")[0].strip()
            if row[:1].isdigit():
                yield "(" + row + ")\n"


def main(stream, receiver, robot):
    with open(receiver, encoding="ascii") as file:
        program = file.read()
    with socket.create_server(("", ROWS_PORT)) as server:
        server.settimeout(CALL_BACK_S)  # an operator answers meanwhile
        with socket.create_connection((robot, ROBOT_PORT), 10) as port:
            own = port.getsockname()[0]
            port.sendall(program.replace("SENDER_ADDRESS", own).encode("ascii"))
            port.recv(79)
        connection, _ = server.accept()
        with connection:
            for row in rows(stream):
                connection.sendall(row.encode("ascii"))
            while connection.recv(64):  # until the receiver has played them
                pass


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
)";

} // namespace

std::string_view urscriptReceiver() {
  return kReceiver;
}

std::string_view urscriptReceiverBegin() {
  return kReceiver.substr(0, kReceiver.find('\n'));
}

std::string_view urscriptSender() {
  return kSender;
}

} // namespace voluta::program
