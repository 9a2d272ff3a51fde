// Whole programs, byte for byte. The numbers were computed apart from the project, from the
// Denavit-Hartenberg table of the UR5 and the bench cell's frames.
#include "program_fixture.h"

#include "program/dialect.h"

#include <algorithm>
#include <iterator>

namespace voluta::program {
namespace {

constexpr double kQuarter = 1.5707963267948966;

class Golden : public test::Programs {
protected:
  void SetUp() override {
    Programs::SetUp();
    process_.accelerationMmPerS2 = 500.0;
    append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0.0, 0.0);
    append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, kQuarter}, 2.0, 0.0);
    append(plan::MoveKind::Linear, {0.01, 0, 0, 0, 0, kQuarter}, 0.1, 0.0);
    append(plan::MoveKind::Print, {0.011, 0, 0, 0, 0, kQuarter}, 0.05, 0.8);
    append(plan::MoveKind::Print, {0.012, 0, 0, 0, 0, kQuarter}, 0.05, 0.8);
    append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 2.0, 0.0);
    for (std::size_t i = 2; i < 5; ++i)
      trajectory_.waypoint[i] = i - 2;
    plan_.position.assign(3, Eigen::Vector3d::Zero());
    plan_.paths.push_back({.first = 0, .count = 3, .layer = 7});
  }
  std::string text(std::string_view format) const {
    return writeProgram(format, input()).files.at(0).text;
  }
};

TEST_F(Golden, urscript) {
  EXPECT_EQ(text("urscript"), R"(def print_part_1():
  # called in the last line, as a file node wants it
  # Robot program for printing, URScript
  # part part 1, job 989d904e1002c6e8
  # cell bench, robot ur5, process fdm-1.0 (PLA)
  # 6 motions, 1.6 mm3, 0 g, 4.2 s
  # joints go, degrees: 0 to 0.7, 0 to 0, 0 to 0, 0 to 0, 0 to 0, 0 to 90
  # starts at joints, degrees: 0, 0, 0, 0, 0, 0; the first motion goes there slowly and straight from wherever the arm stands
  # fixed nozzle: the TCP is the plate's centre, poses are the plate's in Base
  # extruder on: digital output 0; flow: analogue output 0, 1 = 40 mm3/s
  set_tcp(p[0.000000000,0.000000000,0.100000000,0.000000000,0.000000000,0.000000000])
  set_payload(0.5,[0,0,0.1]) # assumed: 0.5 kg of plate, and the part
  set_analog_outputdomain(0,1) # 0 to 10 V
  set_standard_digital_out(0,False)
  set_standard_analog_out(0,0)
  popup("The arm goes slowly and straight to its start. Is the way clear?",title="Voluta",blocking=True)
  movej([0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000],a=0.5,v=0.25)
  # prime
  set_standard_analog_out(0,0.4113)
  set_standard_digital_out(0,True)
  sleep(0.2)
  set_standard_digital_out(0,False)
  # print
  movej([0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,1.5707963],a=1.396,v=0.7853982)
  # layer 7, wall, path 0
  movel(p[-0.8142947,-0.2996078,-0.0054910,1.2165601,-1.2044549,1.2165601],a=1.74,t=0.1)
  set_standard_analog_out(0,0.4)
  set_standard_digital_out(0,True)
  movel(p[-0.8139947,-0.3004219,-0.0054910,1.2172957,-1.2039786,1.2172957],a=2.78,t=0.05,r=0.00039)
  movel(p[-0.8136938,-0.3012358,-0.0054910,1.2180313,-1.2035020,1.2180313],a=0.5,t=0.05)
  set_standard_digital_out(0,False)
  movej([0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000],a=1.396,v=0.7853982)
  # end
  set_standard_digital_out(0,False)
  set_standard_analog_out(0,0)
end
print_part_1()
)");
}

TEST_F(Golden, extendedGcode) {
  EXPECT_EQ(
      text("gcode-extended"),
      R"(; Robot program for printing, extended G-code: X Y Z and the nozzle's direction nX nY nZ in the work frame
; part part 1, job 989d904e1002c6e8
; cell bench, robot ur5, process fdm-1.0 (PLA)
; 6 motions, 1.6 mm3, 0 g, 4.2 s
; FOREIGN: not the language of the cell's controller
; filament diameter 1.75 mm
G21
G90
M82
M117 The arm goes slowly and straight to its start. Is the way clear?
M0
M104 S210 ; assumed for PLA
G28
M109 S210
G92 E0
G1 E1.36808 F410.424 ; prime
G92 E0
G0 X17.2500 Y5.4910 Z-41.4500 nX0.000000 nY1.000000 nZ0.000000 F6000
G0 X5.4910 Y-17.2500 Z-41.4500 nX1.000000 nY0.000000 nZ0.000000 F768.039
; layer 7, wall, path 0
G0 X5.4910 Y-14.7900 Z-49.4624 nX1.000000 nY0.000000 nZ0.000000 F5028.922
G1 X5.4910 Y-14.5485 Z-50.2649 nX1.000000 nY0.000000 nZ0.000000 E0.33260 F1005.66
G1 X5.4910 Y-14.3077 Z-51.0678 nX1.000000 nY0.000000 nZ0.000000 E0.66520 F1005.879
G0 X17.2500 Y5.4910 Z-41.4500 nX0.000000 nY1.000000 nZ0.000000 F748.658
M104 S0
M84
; end
)");
}

// CR LF and the list of modules apart.
TEST_F(Golden, rapid) {
  const std::string whole = text("rapid");
  std::string lines;
  std::remove_copy(whole.begin(), whole.end(), std::back_inserter(lines), '\r');
  EXPECT_EQ(lines, R"(MODULE print_part_1
  ! Robot program for printing, RAPID
  ! FOREIGN: not the language of the cell's controller; Cartesian targets only
  ! part part 1, job 989d904e1002c6e8
  ! cell bench, robot ur5, process fdm-1.0 (PLA)
  ! 6 motions, 1.6 mm3, 0 g, 4.2 s
  ! fixed nozzle: the TCP is the plate's centre, poses are the plate's in world, which is the base while the base frame is zero
  ! extruder on: doExtruder; flow: aoFlow, 1 = 40 mm3/s
  ! expects the signals doExtruder and aoFlow, which goes from 0 to 1: part_1_EIO.cfg
  ! load assumed: 0.5 kg of plate, and the part
  PERS tooldata tPlate:=[TRUE,[[0,0,100],[1,0,0,0]],[0.5,[0,0,100],[1,0,0,0],0,0,0]];
  PERS wobjdata wPrint:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  VAR triggdata tFlow;
  PROC main()
    ConfL\Off;
    ConfJ\Off;
    SetDO doExtruder,0;
    SetAO aoFlow,0;
    UIMsgBox "The arm goes slowly and straight to its start. Is the way clear?";
    MoveJ [[-817.25,-291.45,-5.491],[0.70710678,0.70710678,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[50,20,5000,1000],fine,tPlate\WObj:=wPrint;
    ! prime
    SetAO aoFlow,0.4113;
    SetDO doExtruder,1;
    WaitTime 0.2;
    SetDO doExtruder,0;
    ! print
    MoveJ [[-817.25,-291.45,-5.491],[0.5,0.5,-0.5,0.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[100,500,5000,1000]\T:=2,fine,tPlate\WObj:=wPrint;
    ! layer 7, wall, path 0
    MoveL [[-814.2947,-299.6078,-5.491],[0.49749376,0.50249374,-0.49749376,0.50249374],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[86.7661,500,5000,1000],fine,tPlate\WObj:=wPrint;
    SetAO aoFlow,0.4;
    SetDO doExtruder,1;
    MoveL [[-813.9947,-300.4219,-5.491],[0.49724245,0.50274242,-0.49724245,0.50274242],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[17.3523,500,5000,1000],[FALSE,0.39,0.39,0.39,1,1,1],tPlate\WObj:=wPrint;
    MoveL [[-813.6938,-301.2358,-5.491],[0.49699102,0.50299098,-0.49699102,0.50299098],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[17.3548,500,5000,1000],fine,tPlate\WObj:=wPrint;
    SetDO doExtruder,0;
    MoveJ [[-817.25,-291.45,-5.491],[0.70710678,0.70710678,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[100,500,5000,1000]\T:=2,fine,tPlate\WObj:=wPrint;
    ! end
    SetDO doExtruder,0;
    SetAO aoFlow,0;
  ENDPROC
ENDMODULE
)");
  EXPECT_EQ(writeProgram("rapid", input()).files.at(1).text,
            "<?xml version=\"1.0\" encoding=\"ISO-8859-1\" ?>\r\n<Program>\r\n"
            "\t<Module>part_1.mod</Module>\r\n</Program>\r\n");
}

TEST_F(Golden, jointTable) {
  EXPECT_EQ(text("csv"), R"(# joint table
# part part 1, job 989d904e1002c6e8
# cell bench, robot ur5, process fdm-1.0 (PLA)
# 6 motions, 1.6 mm3, 0 g, 4.2 s
# joints go, degrees: 0 to 0.7, 0 to 0, 0 to 0, 0 to 0, 0 to 0, 0 to 90
# starts at joints, degrees: 0, 0, 0, 0, 0, 0; the first motion goes there slowly and straight from wherever the arm stands
time_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg,extruded_mm3,waypoint,move
0.000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.00000,-1,joint
2.000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,90.0000000,0.00000,-1,joint
2.100000,0.5729578,0.0000000,0.0000000,0.0000000,0.0000000,90.0000000,0.00000,0,linear
2.150000,0.6302536,0.0000000,0.0000000,0.0000000,0.0000000,90.0000000,0.80000,1,print
2.200000,0.6875494,0.0000000,0.0000000,0.0000000,0.0000000,90.0000000,1.60000,2,print
4.200000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,1.60000,-1,joint
# end
)");
}

} // namespace
} // namespace voluta::program
