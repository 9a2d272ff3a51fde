// Whole programs, byte for byte. The numbers were computed apart from the project, from the
// Denavit-Hartenberg table of the UR5 and the bench cell's frames.
#include "program_fixture.h"

#include "program/dialect.h"

#include <algorithm>
#include <iterator>

namespace voluta::program {
namespace {

constexpr double kQuarter = 1.5707963267948966;

std::string withoutCr(const std::string& whole) {
  std::string lines;
  std::remove_copy(whole.begin(), whole.end(), std::back_inserter(lines), '\r');
  return lines;
}

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
  # Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
  # joints go, degrees: 0 to 0.7, 0 to 0, 0 to 0, 0 to 0, 0 to 0, 0 to 90
  # starts at joints, degrees: 0, 0, 0, 0, 0, 0; the first motion goes there slowly and straight from wherever the arm stands
  # fixed nozzle: the TCP is the plate's centre, poses are the plate's in Base
  # extruder on: digital output 0; flow: analogue output 0, 1 = 40 mm3/s
  set_tcp(p[0.000000000,0.000000000,0.100000000,0.000000000,0.000000000,0.000000000])
  set_payload(0.5,[0,0,0.1]) # assumed: 0.5 kg of plate, and the part
  set_analog_outputdomain(0,1) # 0 to 10 V
  set_standard_digital_out(0,False)
  set_standard_analog_out(0,0)
  popup("Nozzle 210 C, plate 60 C? The arm goes straight to its start. Is the way clear?",title="Voluta",blocking=True)
  movej([0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000],a=0.5,v=0.25)
  # prime
  set_standard_analog_out(0,0.4113)
  set_standard_digital_out(0,True)
  sleep(0.2)
  set_standard_digital_out(0,False)
  # print
  movej([0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,1.5707963],a=1.396,v=1.480961)
  # layer 8, wall, path 1
  movel(p[-0.8142947,-0.2996078,-0.0054910,1.2165601,-1.2044549,1.2165601],a=1.74,t=0.1)
  set_standard_analog_out(0,0.4)
  set_standard_digital_out(0,True)
  movel(p[-0.8139947,-0.3004219,-0.0054910,1.2172957,-1.2039786,1.2172957],a=2.78,t=0.05,r=0.00039)
  movel(p[-0.8136938,-0.3012358,-0.0054910,1.2180313,-1.2035020,1.2180313],a=0.5,t=0.05)
  set_standard_digital_out(0,False)
  movej([0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000],a=1.396,v=1.480961)
  # end
  set_standard_digital_out(0,False)
  set_standard_analog_out(0,0)
end
print_part_1()
)");
}

TEST_F(Golden, urscriptStream) {
  EXPECT_EQ(text("urscript-stream"), R"(# joint stream, URScript
# received by part_1_receiver.script
# sent by part_1_sender.py
# part part 1, job 989d904e1002c6e8
# cell bench, robot ur5, process fdm-1.0 (PLA)
# 6 motions, 1.6 mm3, 0 g, 4.2 s
# Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
# joints go, degrees: 0 to 0.7, 0 to 0, 0 to 0, 0 to 0, 0 to 0, 0 to 90
# starts at joints, degrees: 0, 0, 0, 0, 0, 0; the first motion goes there slowly and straight from wherever the arm stands
# extruder: digital output 0; flow: analogue output 0, 1 = 40 mm3/s
kind,seconds,j1_rad,j2_rad,j3_rad,j4_rad,j5_rad,j6_rad,extruder,flow
1,0,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0,0
# prime
3,0.2,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,1,0.4113
# print
2,2,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,1.5707963,0,0
# layer 8, wall, path 1
2,0.1,0.0100000,0.0000000,0.0000000,0.0000000,0.0000000,1.5707963,0,0
2,0.05,0.0110000,0.0000000,0.0000000,0.0000000,0.0000000,1.5707963,1,0.4
2,0.05,0.0120000,0.0000000,0.0000000,0.0000000,0.0000000,1.5707963,1,0.4
2,2,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0,0
0,0,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0.0000000,0,0
)");
}

TEST_F(Golden, extendedGcode) {
  EXPECT_EQ(
      text("gcode-extended"),
      R"(; Robot program for printing, extended G-code: X Y Z and the nozzle's direction nX nY nZ in the work frame
; part part 1, job 989d904e1002c6e8
; cell bench, robot ur5, process fdm-1.0 (PLA)
; 6 motions, 1.6 mm3, 0 g, 4.2 s
; Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
; FOREIGN: not the language of the cell's controller
; filament diameter 1.75 mm
G21
G90
M82
M117 The arm goes slowly and straight to its start. Is the way clear?
M0
M140 S60
M104 S210 ; assumed for PLA
G28
M190 S60
M109 S210
M107
G92 E0
G1 E1.36808 F410.424 ; prime
G92 E0
G0 X17.2500 Y5.4910 Z-41.4500 nX0.000000 nY1.000000 nZ0.000000 F6000
G0 X17.9898 Y2.0202 Z-41.4500 nX0.195090 nY0.980785 nZ0.000000 F851.704
G0 X18.0382 Y-1.5283 Z-41.4500 nX0.382683 nY0.923880 nZ0.000000 F851.719
G0 X17.3935 Y-5.0180 Z-41.4500 nX0.555570 nY0.831470 nZ0.000000 F851.701
G0 X16.0803 Y-8.3149 Z-41.4500 nX0.707107 nY0.707107 nZ0.000000 F851.714
G0 X14.1492 Y-11.2922 Z-41.4500 nX0.831470 nY0.555570 nZ0.000000 F851.694
G0 X11.6743 Y-13.8356 Z-41.4500 nX0.923880 nY0.382683 nZ0.000000 F851.713
G0 X8.7508 Y-15.8473 Z-41.4500 nX0.980785 nY0.195090 nZ0.000000 F851.705
G0 X5.4910 Y-17.2500 Z-41.4500 nX1.000000 nY0.000000 nZ0.000000 F851.708
; layer 8, wall, path 1
G0 X5.4910 Y-14.7900 Z-49.4624 nX1.000000 nY0.000000 nZ0.000000 F5028.922
M106 S255
G1 X5.4910 Y-14.5485 Z-50.2649 nX1.000000 nY0.000000 nZ0.000000 E0.33260 F1005.66
G1 X5.4910 Y-14.3077 Z-51.0678 nX1.000000 nY0.000000 nZ0.000000 E0.66520 F1005.879
G0 X8.2473 Y-13.3160 Z-49.8636 nX0.980785 nY0.195090 nZ0.000000 F760.113
G0 X10.8257 Y-11.7868 Z-48.6600 nX0.923880 nY0.382683 nZ0.000000 F775.287
G0 X13.1200 Y-9.7519 Z-47.4570 nX0.831470 nY0.555570 nZ0.000000 F790.611
G0 X15.0298 Y-7.2644 Z-46.2545 nX0.707107 nY0.707107 nZ0.000000 F806.093
G0 X16.4648 Y-4.3975 Z-45.0525 nX0.555570 nY0.831470 nZ0.000000 F821.738
G0 X17.3487 Y-1.2426 Z-43.8511 nX0.382683 nY0.923880 nZ0.000000 F837.529
G0 X17.6229 Y2.0932 Z-42.6503 nX0.195090 nY0.980785 nZ0.000000 F853.424
G0 X17.2500 Y5.4910 Z-41.4500 nX0.000000 nY1.000000 nZ0.000000 F869.477
M104 S0
M140 S0
M107
M84
; end
)");
}

TEST_F(Golden, tableGcode) {
  const std::string whole = text("gcode-bc");
  // By the formulas of the page from the targets of extended G-code above; between them come
  // pieces.
  for (const char* lines :
       {"; plate over the tilt axis, mm: X0 Z0\n",
        "G1 E1.36808 F410.424 ; prime\nG92 E0\nG1 Z63.3177 F6000\nG1 B-90.00000 C-90.00000 F600\n"
        "G1 X41.4500 Y-17.2500 F6000\nG93\nG1 X41.4500 Y-17.2500 Z5.4910 B-90.00000 C-90.00000 "
        "F103.75829\n",
        "G1 X41.4500 Y-17.2500 Z5.4910 B-90.00000 C-78.75000 F960\n",
        "G1 X41.4500 Y-17.2500 Z5.4910 B-90.00000 C0.00000 F960\n"
        "; layer 8, wall, path 1\n"
        "G1 X49.4624 Y-14.7900 Z5.4910 B-90.00000 C0.00000 F600\nM106 S255\n"
        "G1 X50.2649 Y-14.5485 Z5.4910 B-90.00000 C0.00000 E0.33260 F1200\n"
        "G1 X51.0678 Y-14.3077 Z5.4910 B-90.00000 C0.00000 E0.66520 F1200\n",
        "G94\nM104 S0\nM140 S0\nM107\nM84\n; end\n"})
    EXPECT_NE(whole.find(lines), std::string::npos) << lines << "in\n" << whole;
  EXPECT_TRUE(whole.ends_with("\nG94\nM104 S0\nM140 S0\nM107\nM84\n; end\n"));
}

// CR LF and the list of modules apart.
TEST_F(Golden, rapid) {
  EXPECT_EQ(withoutCr(text("rapid")), R"(MODULE print_part_1
  ! Robot program for printing, RAPID
  ! FOREIGN: not the language of the cell's controller; Cartesian targets only
  ! part part 1, job 989d904e1002c6e8
  ! cell bench, robot ur5, process fdm-1.0 (PLA)
  ! 6 motions, 1.6 mm3, 0 g, 4.2 s
  ! Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
  ! fixed nozzle: a stationary tool, which stands in world, the base while the base frame is zero; the arm holds the work object, poses are the nozzle's on it
  ! extruder on: doExtruder; flow: aoFlow, 1 = 40 mm3/s
  ! expects the signals doExtruder and aoFlow, which goes from 0 to 1: part_1_EIO.cfg
  ! load assumed: 0.5 kg of plate, and the part
  PERS tooldata tNozzle:=[FALSE,[[-800,-250,0],[0,1,0,0]],[0.5,[0,0,100],[1,0,0,0],0,0,0]];
  PERS wobjdata wPlate:=[TRUE,TRUE,"",[[0,0,100],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  VAR triggdata tFlow;
  PROC main()
    ConfL\Off;
    ConfJ\Off;
    SetDO doExtruder,0;
    SetAO aoFlow,0;
    UIMsgBox "Nozzle 210 C, plate 60 C? The arm goes straight to its start. Is the way clear?";
    MoveJ [[17.25,5.491,-41.45],[0.70710678,0.70710678,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[50,20,5000,1000],fine,tNozzle\WObj:=wPlate;
    ! prime
    SetAO aoFlow,0.4113;
    SetDO doExtruder,1;
    WaitTime 0.2;
    SetDO doExtruder,0;
    ! print
    MoveJ [[5.491,-17.25,-41.45],[0.5,0.5,-0.5,-0.5],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[100,500,5000,1000]\T:=2,fine,tNozzle\WObj:=wPlate;
    ! layer 8, wall, path 1
    MoveL [[5.491,-14.79,-49.4624],[0.50249374,0.49749376,-0.50249374,-0.49749376],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[83.8154,500,5000,1000],fine,tNozzle\WObj:=wPlate;
    SetAO aoFlow,0.4;
    SetDO doExtruder,1;
    MoveL [[5.491,-14.5485,-50.2649],[0.50274242,0.49724245,-0.50274242,-0.49724245],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[16.761,500,5000,1000],[FALSE,0.377,0.377,0.377,1,1,1],tNozzle\WObj:=wPlate;
    MoveL [[5.491,-14.3077,-51.0678],[0.50299098,0.49699102,-0.50299098,-0.49699102],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[16.7646,500,5000,1000],fine,tNozzle\WObj:=wPlate;
    SetDO doExtruder,0;
    MoveJ [[17.25,5.491,-41.45],[0.70710678,0.70710678,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],[100,500,5000,1000]\T:=2,fine,tNozzle\WObj:=wPlate;
    ! end
    SetDO doExtruder,0;
    SetAO aoFlow,0;
  ENDPROC
ENDMODULE
)");
  EXPECT_EQ(writeProgram("rapid", input()).files.at(2).text,
            "<?xml version=\"1.0\" encoding=\"ISO-8859-1\" ?>\r\n<Program>\r\n"
            "\t<Module>part_1.mod</Module>\r\n</Program>\r\n");
}

// Without carriage returns, from the line that begins so.
std::string from(const std::string& whole, const std::string& begin) {
  std::string lines;
  std::remove_copy(whole.begin(), whole.end(), std::back_inserter(lines), '\r');
  const std::size_t at = lines.find("\n" + begin);
  return at == std::string::npos ? lines : lines.substr(at + 1);
}

// Positions as RAPID's; B is the base's turn, 0.01, 0.011 and 0.012 rad.
TEST_F(Golden, krl) {
  EXPECT_EQ(from(text("krl"), ";FOLD INI"), R"(;FOLD INI
GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )
INTERRUPT ON 3
BAS (#INITMOV,0 )
;ENDFOLD (INI)
$ADVANCE=5
$IPO_MODE=#TCP
$BASE={X -800,Y -250,Z 0,A 0,B 0,C 180}
$TOOL={X 0,Y 0,Z 100,A 0,B 0,C 0}
$LOAD={M 0.5,CM {X 0,Y 0,Z 100,A 0,B 0,C 0},J {X 0,Y 0,Z 0}} ; assumed: 0.5 kg of plate, and the part
$ACC.CP=10
$VEL.ORI1=200
$VEL.ORI2=200
$OUT[1]=FALSE
$ANOUT[1]=0
MsgNotify("Nozzle 210 C, plate 60 C? The arm goes straight to its start. Is the way clear?")
HALT
BAS (#VEL_PTP,10)
PTP {X 17.25,Y 5.491,Z -41.45,A 0,B 0,C 90}
; prime
$ANOUT[1]=0.4113
$OUT[1]=TRUE
WAIT SEC 0.2
$OUT[1]=FALSE
; print
BAS (#VEL_PTP,25)
PTP {X 5.491,Y -17.25,Z -41.45,A -90,B 0,C 90}
; layer 8, wall, path 1
$VEL.CP=0.0838154
LIN {X 5.491,Y -14.79,Z -49.4624,A -90,B -0.57296,C 90}
$ANOUT[1]=0.4
$OUT[1]=TRUE
$VEL.CP=0.016761
$APO.CDIS=0.34
LIN {X 5.491,Y -14.5485,Z -50.2649,A -90,B -0.63025,C 90} C_DIS
$VEL.CP=0.0167646
LIN {X 5.491,Y -14.3077,Z -51.0678,A -90,B -0.68755,C 90}
$OUT[1]=FALSE
PTP {X 17.25,Y 5.491,Z -41.45,A 0,B 0,C 90}
; end
$OUT[1]=FALSE
$ANOUT[1]=0
END
)");
}

// Positions as URScript's: the plate's in Base. The upright axis is used for U and W alike.
TEST_F(Golden, spel) {
  EXPECT_EQ(from(text("spel"), "  Motor On"), R"(  Motor On
  Power Low
  TLSet 1, XY(0,0,100,0,0,0)
  Tool 1
  ECPSet 1, XY(-800,-250,0,0,0,180)
  ECP 1
  AutoLJM On
  Weight 0.5 ' assumed: 0.5 kg of plate, and the part
  Off 1
  AIO_Out 1, 0
  Print "Nozzle 210 C, plate 60 C? The arm goes straight to its start. Is the way clear?"
  Pause
  Speed 10
  Go XY(-817.25,-291.45,-5.491,0,0,90)
  Power High
  ' prime
  AIO_Out 1, 4.113
  On 1
  Wait 0.2
  Off 1
  ' print
  Speed 25
  Go XY(-817.25,-291.45,-5.491,90,-90,0)
  ' layer 8, wall, path 1
  SpeedS 83.815
  AccelS 5000
  Move XY(-814.29469,-299.60779,-5.491,90.57296,-90,0) ECP
  AIO_Out 1, 4
  On 1
  SpeedS 16.7631
  Move XY(-813.99467,-300.42194,-5.491,90.63025,-90,0) ECP CP
  SpeedS 16.763
  Move XY(-813.69384,-301.23578,-5.491,90.68755,-90,0) ECP
  Off 1
  Go XY(-817.25,-291.45,-5.491,0,0,90)
  ' end
  Off 1
  AIO_Out 1, 0
Fend
)");
}

TEST_F(Golden, jointTable) {
  EXPECT_EQ(text("csv"), R"(# joint table
# part part 1, job 989d904e1002c6e8
# cell bench, robot ur5, process fdm-1.0 (PLA)
# 6 motions, 1.6 mm3, 0 g, 4.2 s
# Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
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

// CR LF behind each step. Angles are the rotation vectors of URScript above, the plate turned by
// Rz Ry Rx; speeds those of the nozzle on it, as RAPID's.
TEST_F(Golden, melfa) {
  EXPECT_EQ(withoutCr(text("melfa")), R"(1 ' Robot program for printing, MELFA-BASIC V
2 ' FOREIGN: not the language of the cell's controller; Cartesian targets only
3 ' part part 1, job 989d904e1002c6e8
4 ' cell bench, robot ur5, process fdm-1.0 (PLA)
5 ' 6 motions, 1.6 mm3, 0 g, 4.2 s
6 ' Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
7 ' fixed nozzle: Ex-T control, work coordinates 1 are the nozzle's; the TCP is the plate's
8 ' centre, positions are the plate's in the robot's base
9 ' extruder on: output 10; flow: outputs 16 to 31 as a number, 10000 = 40 mm3/s
10 ' load assumed: 0.5 kg, to be set in HNDDAT1
11 Tool (0,0,100,0,0,0)(0,0)
12 Base P_NBase
13 P_WkCord(1)=(-800,-250,0,180,0,0)(0,0)
14 Ovrd 100
15 Accel 100,100
16 Cnt 0
17 M_Out(10)=0
18 M_Outw(16)=0
19 ' Nozzle 210 C, plate 60 C? The arm goes straight to its start. Is the way clear?
20 ' Hlt waits for the operator's start
21 Hlt
22 JOvrd 8
23 Mov (-817.25,-291.45,-5.491,90,0,0)(7,0)
24 ' prime
25 M_Outw(16)=4113
26 M_Out(10)=1
27 Dly 0.2
28 M_Out(10)=0
29 ' print
30 JOvrd 25
31 Mov (-817.25,-291.45,-5.491,0,-90,90)(7,0)
32 ' layer 8, wall, path 1
33 Spd 83.81495
34 EMvs 1,(-814.2947,-299.6078,-5.491,0,-90,90.57296)(7,0)
35 M_Outw(16)=4000
36 M_Out(10)=1
37 Spd 16.76217
38 Cnt 1,0.377,0.377
39 EMvs 1,(-813.9947,-300.4219,-5.491,0,-90,90.63025)(7,0)
40 EMvs 1,(-813.6938,-301.2358,-5.491,0,-90,90.68755)(7,0)
41 Cnt 0
42 M_Out(10)=0
43 Mov (-817.25,-291.45,-5.491,90,0,0)(7,0)
44 ' end
45 M_Out(10)=0
46 M_Outw(16)=0
47 End
)");
}

// The same motions as the melfa program's, a line each, and the program that takes them.
TEST_F(Golden, melfaDatalink) {
  const plan::Program program = writeProgram("melfa-datalink", input());
  EXPECT_EQ(program.files[0].text, R"(# lines for a data link, MELFA-BASIC V
# taken by part_1_link.prg
# sent by part_1_link.py
# FOREIGN: not the language of the cell's controller; Cartesian targets only
# part part 1, job 989d904e1002c6e8
# cell bench, robot ur5, process fdm-1.0 (PLA)
# 6 motions, 1.6 mm3, 0 g, 4.2 s
# Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
# extruder on: output 10; flow: outputs 16 to 31 as a number, 10000 = 40 mm3/s
x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,mm_per_s,flow,blend_mm
tool,0,0,100,0,0,0
nozzle,-800,-250,0,180,0,0
-817.25,-291.45,-5.491,90,0,0,8,0,-2
# prime
-817.25,-291.45,-5.491,90,0,0,-0.2,4113,-2
# print
-817.25,-291.45,-5.491,0,-90,90,25,0,-2
# layer 8, wall, path 1
-814.2947,-299.6078,-5.491,0,-90,90.57296,83.81495,0,0
-813.9947,-300.4219,-5.491,0,-90,90.63025,16.76217,4000,0.377
-813.6938,-301.2358,-5.491,0,-90,90.68755,16.7645,4000,0
-817.25,-291.45,-5.491,90,0,0,25,0,-2
-817.25,-291.45,-5.491,90,0,0,0,0,-2
)");
  EXPECT_EQ(withoutCr(program.files[1].text), R"(1 ' Takes lines by data link, MELFA-BASIC V
2 ' part part 1, job 989d904e1002c6e8
3 ' cell bench, robot ur5, process fdm-1.0 (PLA)
4 ' 6 motions, 1.6 mm3, 0 g, 4.2 s
5 ' Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
6 ' extruder on: output 10; flow: outputs 16 to 31 as a number, 10000 = 40 mm3/s
7 ' fixed nozzle: Ex-T control, work coordinates 1 are the nozzle's
8 ' COM3 is the network: COMDEV's third OPT13, its CPRCE13 2, port 10003, the robot serves
9 ' The arm goes slowly and straight to its start. Is the way clear?
10 Tool (0,0,100,0,0,0)(0,0)
11 Base P_NBase
12 P_WkCord(1)=(-800,-250,0,180,0,0)(0,0)
13 Ovrd 100
14 Accel 100,100
15 Cnt 0
16 M_Out(10)=0
17 M_Outw(16)=0
18 Hlt
19 JOvrd 8
20 P1=(-817.25,-291.45,-5.491,90,0,0)(7,0)
21 Mov P1
22 Open "COM3:" As #1
23 *OPENS
24 If M_Open(1)<>1 Then GoTo *OPENS
25 Def Act 1,M_Open(1)<>1 GoTo *LOST
26 Act 1=1
27 *TAKES
28 Input #1,M1,M2,M3,M4,M5,M6,M7,M8,M9
29 If M7=0 Then GoTo *DONE
30 If M7<0 Then GoTo *STAYS
31 If M9<0 Then GoTo *JOINTS
32 GoSub *POSE
33 Spd M7
34 If M9>0 Then
35 Cnt 1,M9,M9
36 EndIf
37 If M8=0 Then
38 M_Out(10)=0
39 EndIf
40 If M8>0 Then
41 M_Out(10)=1
42 EndIf
43 EMvs 1,P1 Wth M_Outw(16)=M8
44 If M9=0 Then
45 Cnt 0
46 EndIf
47 Print #1,M7
48 GoTo *TAKES
49 *JOINTS
50 M_Out(10)=0
51 M_Outw(16)=0
52 JOvrd M7
53 GoSub *POSE
54 Mov P1
55 Print #1,M7
56 GoTo *TAKES
57 *STAYS
58 M_Outw(16)=M8
59 If M8>0 Then
60 M_Out(10)=1
61 EndIf
62 Dly -M7
63 M_Out(10)=0
64 Print #1,M7
65 GoTo *TAKES
66 *DONE
67 Print #1,M7
68 *LOST
69 M_Out(10)=0
70 M_Outw(16)=0
71 Act 1=0
72 Close #1
73 End
74 *POSE
75 P1.X=M1
76 P1.Y=M2
77 P1.Z=M3
78 P1.A=Rad(M4)
79 P1.B=Rad(M5)
80 P1.C=Rad(M6)
81 Return
)");
}

TEST_F(Golden, tmscript) {
  EXPECT_EQ(withoutCr(text("tmscript")),
            R"(// Robot program for printing, TMscript: frames for a listen node, port 5890
// send a frame, wait for its OK, keep few in the queue; lines with // are not sent
// FOREIGN: not the language of the cell's controller; Cartesian targets only
// part part 1, job 989d904e1002c6e8
// cell bench, robot ur5, process fdm-1.0 (PLA)
// 6 motions, 1.6 mm3, 0 g, 4.2 s
// Nozzle 210 degrees C, plate 60 degrees C, fan 100 % from layer 2 on
// fixed nozzle: the TCP is the plate's centre, poses are the plate's in RobotBase
// extruder on: DO 0 of the control box; flow: AO 0, 10 V = 40 mm3/s
// the pendant shows no text at a stop: before it the text goes to the sender of the
// frames ($TMSTA 90), which has to show it
$TMSCT,25,1,ChangeBase("RobotBase"),*08
$TMSCT,32,2,ChangeTCP({0,0,100,0,0,0},0.5),*22
$TMSCT,26,3,IO["ControlBox"].DO[0]=0,*66
$TMSCT,26,4,IO["ControlBox"].AO[0]=0,*64
$TMSCT,98,5,ListenSend(90,"Nozzle 210 C, plate 60 C? The arm goes straight to its start. Is the way clear?"),*54
$TMSCT,9,6,Pause(),*01
$TMSCT,56,7,PTP("CPP",-817.25,-291.45,-5.491,90,0,0,8,500,0,false),*3E
// prime
$TMSCT,30,8,IO["ControlBox"].AO[0]=4.113,*76
$TMSCT,26,9,IO["ControlBox"].DO[0]=1,*6D
$TMSCT,14,10,PVTEnter(1),*73
$TMSCT,58,11,PVTPoint(-817.25,-291.45,-5.491,90,0,0,0,0,0,0,0,0,0.2),*62
$TMSCT,12,12,PVTExit(),*2E
$TMSCT,27,13,IO["ControlBox"].DO[0]=0,*56
// print
$TMSCT,60,14,PTP("CPP",-817.25,-291.45,-5.491,0,-90,90,25,500,0,false),*22
// layer 8, wall, path 1
$TMSCT,14,15,PVTEnter(1),*76
$TMSCT,70,16,PVTPoint(-814.2947,-299.6078,-5.491,0,-90,90.57296,0,0,0,0,0,0,0.1),*65
$TMSCT,27,17,IO["ControlBox"].AO[0]=4,*53
$TMSCT,27,18,IO["ControlBox"].DO[0]=1,*5C
$TMSCT,84,19,PVTPoint(-813.9947,-300.4219,-5.491,0,-90,90.63025,6.009,-16.28,0,0,0,1.146,0.05),*61
$TMSCT,71,20,PVTPoint(-813.6938,-301.2358,-5.491,0,-90,90.68755,0,0,0,0,0,0,0.05),*5D
$TMSCT,27,21,IO["ControlBox"].DO[0]=0,*57
$TMSCT,12,22,PVTExit(),*2D
$TMSCT,64,23,PTP("CPP",-817.25,-291.45,-5.491,-90,-180,180,25,500,0,false),*36
// end
$TMSCT,27,24,IO["ControlBox"].DO[0]=0,*52
$TMSCT,27,25,IO["ControlBox"].AO[0]=0,*56
$TMSCT,15,26,ScriptExit(),*53
)");
}

} // namespace
} // namespace voluta::program
