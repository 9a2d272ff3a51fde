// Every word of each language, inserted into a print: it is read with its effect, known to change
// nothing, or refused at its line. The lists are the makers': URScript manual, "Module motion",
// "Module internals", "Module interfaces", "Module ioconfiguration"; ABB, RAPID Instructions,
// Functions and Data types; the RepRap wiki's list of G-codes; KUKA, instructions of the KSS manual
// for system integrators; Epson, SPEL+ Language Reference.
#include "program/dialect.h"
#include "program/gcode/gcode_reader.h"
#include "program/krl/krl.h"
#include "program/melfa/melfa.h"
#include "program/rapid/rapid.h"
#include "program/spel/spelplus.h"
#include "program/tmscript/tmscript.h"
#include "program/tmscript/tmscript_frames.h"
#include "program/urscript/urscript.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace voluta::program {
namespace {

plan::ReadProgram read(std::string_view format, const std::string& text) {
  process::Process process;
  process.maxFlowMm3PerS = 40.0;
  return readProgram(format, {{"file", text}}, process::Tooling(process));
}

// Index of the line inserted into the print of the programs below, while the extruder is on.
constexpr std::size_t kDuringPrint = 8;

std::string urscript(const std::string& head, const std::string& middle, const std::string& end) {
  return "def f():\n set_tcp(p[0,0,0.1,0,0,0])\n" + head +
         " set_standard_digital_out(0,False)\n set_standard_analog_out(0,0.1)\n"
         " movel(p[-0.4,0,0.3,0,3,0],a=1,v=0.1)\n set_standard_digital_out(0,True)\n"
         " movel(p[-0.4,0,0.301,0,3,0],t=0.1)\n" +
         middle +
         " movel(p[-0.4,0,0.302,0,3,0],t=0.1)\n set_standard_digital_out(0,False)\n"
         " set_standard_analog_out(0,0)\n" +
         end + "end\nf()\n";
}

std::string withCrLf(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

std::string rapid(const std::string& head, const std::string& middle, const std::string& end) {
  const auto move = [](const std::string& z) {
    return "MoveL [[400,0," + z +
           "],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v20,fine,t1\\WObj:=wobj0;\n";
  };
  return withCrLf("MODULE m\nPERS tooldata t1:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,100],[1,0,0,0],"
                  "0,0,0]];\nPROC main()\nConfL\\Off;\n" +
                  head + "SetDO doExtruder,1; SetAO aoFlow,0.1;\n" + move("300") + move("301") +
                  middle + move("302") + "SetDO doExtruder,0;\nSetAO aoFlow,0;\n" + end +
                  "ENDPROC\nENDMODULE\n");
}

std::string melfa(const std::string& head, const std::string& middle, const std::string& end) {
  return withCrLf("Tool (0,0,100,0,0,0)\nSpd 20\n" + head +
                  "M_Out(10)=1\nM_Outw(16)=1000\nMov (400,0,300,180,0,180)(7,0)\n"
                  "Mvs (400,0,301,180,0,180)(7,0)\n'\n" +
                  middle + "Mvs (400,0,302,180,0,180)(7,0)\nM_Out(10)=0\nM_Outw(16)=0\n" + end +
                  "End\n");
}

// Each line in a frame of its own.
std::string tmscript(const std::string& head, const std::string& middle, const std::string& end) {
  const auto line = [](const std::string& z) {
    return "Line(\"CAP\",400,0," + z + ",180,0,180,20,200,0,false)\n";
  };
  std::istringstream lines("ChangeTCP({0,0,100,0,0,0},1.5)\n" + head +
                           "IO[\"ControlBox\"].DO[0]=1\nIO[\"ControlBox\"].AO[0]=1\n" +
                           line("300") + line("301") + "//\n//\n" + middle + line("302") +
                           "IO[\"ControlBox\"].DO[0]=0\nIO[\"ControlBox\"].AO[0]=0\n" + end +
                           "ScriptExit()\n");
  std::string text;
  for (std::string script; std::getline(lines, script);)
    text += script.starts_with("//") ? script + "\r\n" : tmFrame("1", script);
  return text;
}

std::string gcode(const std::string& head, const std::string& middle, const std::string& end) {
  return "G21\nG90\nM82\n" + head +
         "G92 E0\nG0 X0 Y0 Z1 nX0 nY0 nZ1 F600\nG1 X1 E0.1\nG1 X2 E0.2\n" + middle +
         "G1 X3 E0.3\nM104 S0\nM84\n" + end + "; end\n";
}

std::string plainGcode(const std::string& head, const std::string& middle, const std::string& end) {
  return "G21\nG90\nM82\n" + head + "G92 E0\nG0 X0 Y0 Z1 F600\nG1 X1 E0.1\nG1 X2 E0.2\n" + middle +
         "G1 X3 E0.3\nM104 S0\nM84\n" + end + "; end\n";
}

std::string tableGcode(const std::string& head, const std::string& middle, const std::string& end) {
  return "G21\n" + head +
         "G1 Z9 F600\nG1 B0 C0 F600\nG93\nG1 X0 Y0 Z1 F60\nG1 X1 E0.1 F60\n"
         "G1 X2 E0.2 F60\n" +
         middle + "G1 X3 E0.3 F60\nM104 S0\nM84\n" + end + "; end\n";
}

std::string krl(const std::string& head, const std::string& middle, const std::string& end) {
  return "DEF f ( )\n$BASE=$NULLFRAME\n$TOOL=$NULLFRAME\n$VEL.CP=0.02\n$ANOUT[1]=0.1\n" + head +
         "$OUT[1]=TRUE\nPTP {X 400,Y 0,Z 300,A 0,B 0,C 180}\n" + middle +
         "LIN {Z 301}\nLIN {Z 302}\n$OUT[1]=FALSE\n$ANOUT[1]=0\n" + end + "END\n";
}

std::string spelplus(const std::string& head, const std::string& middle, const std::string& end) {
  return "Function f\n  Motor On\n  Power High; SpeedS 20\n  AIO_Out 1, 1\n  Speed 10\n" + head +
         "  On 1\n  Go XY(400,0,300,0,0,180)\n" + middle +
         "  Move XY(400,0,301,0,0,180)\n  Move XY(400,0,302,0,0,180)\n  Off 1\n"
         "  AIO_Out 1, 0\n" +
         end + "Fend\n";
}

// Stops are compared with the planned ones by the replay (replay/planned_events.h).
std::size_t stopsOf(const plan::ReadProgram& program) {
  return static_cast<std::size_t>(
      std::ranges::count(program.facts, plan::FactKind::OperatorStop, &plan::StatedFact::kind));
}

bool tells(const plan::ReadProgram& with, const plan::ReadProgram& without) {
  return !with.defects.empty() || stopsOf(with) != stopsOf(without) ||
         with.pauses.size() != without.pauses.size() ||
         with.motions.size() != without.motions.size();
}

// `taken`: the words that may be anywhere.
void expectAllKnownOrRefused(std::string_view format, const std::vector<std::string>& lines,
                             std::string (*program)(const std::string&, const std::string&,
                                                    const std::string&),
                             std::size_t line, const std::vector<std::string>& taken) {
  const plan::ReadProgram without = read(format, program("", "", ""));
  for (const auto& d : without.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  EXPECT_TRUE(without.complete);
  for (const std::string& code : lines) {
    SCOPED_TRACE(code);
    const plan::ReadProgram with = read(format, program("", code + "\n", ""));
    const std::string word = code.substr(0, code.find_first_of(" (;"));
    const bool free = std::find(taken.begin(), taken.end(), word) != taken.end();
    EXPECT_EQ(tells(with, without), !free);
    if (!with.defects.empty()) {
      EXPECT_EQ(with.defects.front().line, line);
    }
  }
}

std::vector<std::string> wordsOf(const char* list, const std::string& arguments) {
  std::istringstream in(list);
  std::vector<std::string> words;
  for (std::string word; in >> word;)
    words.push_back(word + arguments);
  return words;
}

TEST(Words, OfUrscriptAreKnownOrRefused) {
  constexpr const char* kManual =
      "conveyor_pulse_decode encoder_enable_pulse_decode encoder_enable_set_tick_count "
      "encoder_get_tick_count encoder_set_tick_count end_force_mode end_freedrive_mode "
      "end_screw_driving end_teach_mode force_mode force_mode_set_damping "
      "force_mode_set_gain_scaling freedrive_mode freedrive_mode_no_incorrect_payload_check "
      "get_conveyor_tick_count get_target_tcp_pose_along_path get_target_tcp_speed_along_path "
      "movec path_offset_disable path_offset_enable path_offset_get path_offset_set "
      "path_offset_set_alpha_filter path_offset_set_max_offset pause_on_error_code "
      "position_deviation_warning reset_revolution_counter screw_driving servoc servoj servol "
      "set_conveyor_tick_count set_pos set_safety_mode_transition_hardness speedj speedl "
      "stop_conveyor_tracking stopj stopl teach_mode track_conveyor_circular "
      "track_conveyor_linear force get_actual_joint_positions get_actual_tcp_pose "
      "get_controller_temp get_inverse_kin get_steptime get_tcp_force halt high_holding_torque_"
      "disable high_holding_torque_enable is_steady is_within_safety_limits popup powerdown "
      "protective_stop set_gravity set_payload set_payload_cog set_payload_mass "
      "set_target_payload set_tcp sync textmsg write_output_boolean_register "
      "write_output_float_register enable_external_ft_sensor ft_rtde_input_enable "
      "gripper set_analog_inputrange set_analog_out set_analog_outputdomain "
      "set_configurable_digital_out set_digital_out set_flag set_standard_analog_input_domain "
      "set_standard_analog_out set_standard_digital_out set_tool_analog_input_domain "
      "set_tool_communication set_tool_digital_out set_tool_output_mode set_tool_voltage "
      "modbus_set_output_register modbus_set_output_signal modbus_send_custom_command "
      "rpc_factory rtde_set_watchdog socket_open socket_close socket_send_string "
      "socket_send_line socket_read_string set_runstate_standard_digital_output_to_value "
      "set_runstate_tool_digital_output_to_value set_input_actions_to_default "
      "set_standard_digital_input_action sleep movel movej movep zero_ftsensor set_baselight_off "
      "enter_critical exit_critical join kill run interpreter_mode end_interpreter_mode "
      "clear_interpreter tool_contact set_failure_action torque_command direct_torque";
  expectAllKnownOrRefused("urscript", wordsOf(kManual, "(1)"), urscript, kDuringPrint,
                          {"textmsg", "set_flag"});
}

TEST(Words, OfRapidAreKnownOrRefused) {
  constexpr const char* kManual =
      "AccSet ActEventBuffer ActUnit Add AliasIO BitClear BitSet BookErrNo Break CallByVar "
      "CamFlush "
      "CapL CancelLoad CheckProgRef CirPathMode Clear ClearIOBuff ClearPath ClkReset ClkStart "
      "ClkStop Close ConfJ ConfL CONNECT CopyFile CorrClear CorrCon CorrWrite DeactUnit Decr "
      "DitherAct DitherDeact DropSensor EOffsOff EOffsOn EOffsSet EraseModule ErrLog ErrRaise "
      "ErrWrite EXIT ExitCycle FOR GetSysData GOTO GripLoad HollowWristReset IDelete IDisable "
      "IEnable IF Incr IndAMove IndCMove IndDMove IndReset IndRMove InvertDO IOBusStart IPers "
      "IRMQMessage ISignalAI ISignalDI ISleep ITimer IWatch Load MakeDir ManLoadIdProc "
      "MechUnitLoad "
      "MotionProcessModeSet MotionSup MoveAbsJ MoveC MoveCDO MoveExtJ MoveJ MoveJDO MoveL MoveLDO "
      "MToolRotCalib Open OpenDir PathAccLim PathLengthReset PathRecStart PathResol PDispOff "
      "PDispOn PDispSet ProcCall ProcerrRecovery PulseDO RAISE RaiseToUser ReadAnyBin ReadBlock "
      "RemoveDir Reset ResetPPMoved RestoPath RETURN Rewind RMQSendMessage Save SearchC SearchL "
      "SenDevice Set SetAllDataVal SetAO SetDataVal SetDO SetGO SetSysData SimCollision SingArea "
      "SkipWarn SocketAccept SocketConnect SocketSend SoftAct SoftDeact SoftElbow SpeedLimAxis "
      "SpeedLimCheckPoint SpeedRefresh SpyStart StartLoad StartMove Stop StopMove StorePath "
      "SyncMoveOff SyncMoveOn SystemStopAction TEST TestSignDefine TextTabInstall TPErase "
      "TPReadDnum TPReadFK TPReadNum TPShow TPWrite TriggC TriggCheckIO TriggDataCopy TriggEquip "
      "TriggInt TriggIO TriggJ TriggL TriggLIOs TriggRampAO TriggSpeed TriggStopProc TryInt "
      "TuneReset TuneServo UIMsgBox UIShow UnLoad UnpackRawBytes VelSet WaitAI WaitDI WaitDO "
      "WaitGI WaitLoad WaitRob WaitSyncTask WaitTestAndSet WaitTime WaitUntil WarmStart WHILE "
      "WorldAccLim Write WriteBin WZBoxDef WZDOSet WZEnable WZFree";
  expectAllKnownOrRefused("rapid", wordsOf(kManual, " 1;"), rapid, kDuringPrint,
                          {"ClkReset", "ClkStart", "ClkStop", "ErrWrite", "TPErase", "TPWrite"});
}

TEST(Words, OfKrlAreKnownOrRefused) {
  constexpr const char* kManual =
      "ANIN ANOUT ASYPTP BRAKE CASE CAST_FROM CCLOSE CHANNEL CIRC CIRC_REL CONFIRM CONTINUE COPEN "
      "CREAD CWRITE DEFAULT DIGIN ELSE ENDFOR ENDIF ENDLOOP ENDSPLINE ENDSWITCH ENDWHILE ENUM "
      "ERR_RAISE EXIT EXT EXTFCT FOR GOTO HALT IF INTERRUPT LIN_REL LOOP MsgNotify MsgDialog "
      "MsgQuit "
      "PTP_REL PTP_SPLINE PULSE REPEAT RESUME RETURN SCIRC SLIN_REL SPL SPLINE SPTP_REL SREAD "
      "STRUC "
      "SWAIT SWITCH SWRITE SYN TIME_BLOCK TIMER_STOP TRIGGER UNTIL WHILE SHIFT MOVE_ENABLE LK "
      "SET_OV AUT EMI_ACT IR_STOPM RSI_MOVECORR";
  expectAllKnownOrRefused("krl", wordsOf(kManual, " (1)"), krl, kDuringPrint, {"MsgNotify"});
  constexpr const char* kVariables =
      "$OV_PRO $OV_ROB $ADVANCE $RED_VEL $RED_ACC $VEL_EXTAX $ACC_AXIS $ACC_EXTAX $ORI_TYPE "
      "$CIRC_TYPE $SINGUL_STRATEGY $TORQUE_AXIS $SOFTN_END $SOFTP_END $WORLD $ROBROOT $IPO_MODE "
      "$ACT_BASE $ACT_TOOL $LOAD_A1 $APO_DIS_PTP $GEAR_JERK $JERK $CURR_RED $DIRECTION $TRAFONAME "
      "$BWDSTART $TIMER $FLAG $CYCFLAG $OUT_C $PRO_MODE $STOPNOAPROX";
  expectAllKnownOrRefused("krl", wordsOf(kVariables, "=1"), krl, kDuringPrint,
                          {"$BWDSTART=1", "$TIMER=1", "$FLAG=1"});
}

TEST(Words, OfSpelplusAreKnownOrRefused) {
  constexpr const char* kManual =
      "Accel AccelR AccelS Align AlignECP Arc Arc3 Arch Arm ArmCalib ArmClr ArmSet ATCLR AutoLJM "
      "AutoOrientationFlag AvoidSingularity Base BClose BGo BMove BOpen Box BoxClr Brake BTst "
      "Calib "
      "ChDir ChDisk ChDrive ClearPoints CloseCom CloseNet Cls Cnv_QueAdd CollisionDetect Curve "
      "CVMove "
      "Cnv_AbortTrack ECP ECPClr ECPSet ElapsedTime ErrorOn EResume Error Exit FGRun Fine Find "
      "Force_"
      "Calibrate GClose GGet GoSub GoTo GSet Halt Home HomeSet Hordr Hofs If Inertia InputBox "
      "JRange JTran Jump Jump3 Jump3CP JumpTLZ LatchEnable LimitTorque LimZ LoadPoints Local "
      "LocalClr "
      "MCal MCordr MemOff MemOn MemOut MHour Motor MsgBox OnErr OpBCD OpenCom OpenNet Out OutReal "
      "OutW P_ Palet Pallet Pass Pause PerformMode PG_Scan Plane PlaneClr Power Print PTPBoost "
      "Pulse "
      "QPDecelR QP Quit Range Recover Reset ResetElapsedTime Restart Resume Return Robot RunDialog "
      "SafetyOn SavePoints Select SetCom SetIn SetNet SetSw SFree Shutdown Signal SingularitySpeed "
      "SLock SoftCP SpeedFactor StartMain SyncLock SyncRobots TC TCLim TCSpeed TGo Till TLClr "
      "TMove "
      "TMOut Toff Ton Trap VRun Wait WaitNet WaitPos WaitSig Weight Where WOpen WorkQue_Add Xqt "
      "XYLim "
      "ZeroFlg";
  expectAllKnownOrRefused("spel", wordsOf(kManual, " 1"), spelplus, kDuringPrint,
                          {"Accel", "AccelR", "AccelS", "Cls", "MemOff", "MemOn", "Print"});
}

TEST(Words, OfMelfaAreKnownOrRefused) {
  constexpr const char* kManual =
      "Accel Act Base CallP ChrSrch CavChk Close ClrM Cmp CmpG ColChk ColLvl Com Def Dim Dly EMvc "
      "EMvr EMvr2 EMvr3 EMvs EMvSpl Error Fine For FPrm Fsc GetM GetPos GoSub GoTo Hlt HOpen "
      "HClose If Input JOvrd JRC LoadSet Mov Mva Mvc Mvr Mvr2 Mvr3 Mvs MvSpl MvTune Mxt Next OAdl "
      "On Open Ovrd Plt Prec Print Priority PVSCal RelM Rem Reset Return Select Servo SetCalFrm "
      "SetExtArea Skip Spd SpdOpt SplSpd SplPos Title Tool Torq Trk TrChk TrClr TrOut TrRst TrWcur "
      "VxDr Wait While WEnd Wth WthIf XClr XLoad XRst XRun XStp ZoneChk";
  expectAllKnownOrRefused("melfa", wordsOf(kManual, " 1"), melfa, kDuringPrint,
                          {"Dim", "Rem", "Title", "Spd", "Ovrd"});
}

TEST(Words, OfTmscriptAreKnownOrRefused) {
  constexpr const char* kManual =
      "PTP Line Circle PLine Move_PTP Move_Line Move_PLine ChangeBase ChangeTCP ChangeLoad "
      "PVTExit PVTPoint PVTPause PVTResume QueueTag WaitQueueTag StopAndClearBuffer Pause Resume "
      "Vision_DoJob Vision_DoJob_PTP Vision_IsJobAvailable SuspendContinue Force_Start "
      "Compliance_Start TouchStop_Start StartContinueVmove SetContinueVmove StopContinueVmove "
      "StartContinueVLine StopContinueVLine modbus_write socket_send com_write Sleep goto";
  expectAllKnownOrRefused("tmscript", wordsOf(kManual, "(1)"), tmscript, kDuringPrint,
                          {"QueueTag"});
}

TEST(Words, OfGcodeAreKnownOrRefused) {
  // All numbers that the wiki has, and those it has not.
  std::vector<std::string> lines;
  for (int g = 0; g < 300; ++g)
    lines.push_back("G" + std::to_string(g) + " S5");
  for (int m = 0; m < 1000; ++m)
    lines.push_back("M" + std::to_string(m) + " S5");
  for (int t = 0; t < 10; ++t)
    lines.push_back("T" + std::to_string(t) + " S5");
  std::vector<std::string> taken = {"G17",  "G92",  "G21",  "G40",  "G49",  "G80",  "G90",
                                    "M73",  "M82",  "M83",  "M105", "M106", "M107", "M110",
                                    "M111", "M114", "M115", "M117", "M118", "M400", "T0"};
  // Back to speeds a minute the next motion has none: refused at its own line.
  std::vector<std::string> ofTable = lines;
  std::erase(ofTable, "G94 S5");
  taken.emplace_back("G93");
  expectAllKnownOrRefused("gcode-bc", ofTable, tableGcode, kDuringPrint, taken);
  taken.back() = "G94";
  expectAllKnownOrRefused("gcode-extended", lines, gcode, kDuringPrint, taken);
  for (const char* word : {"M75", "M76", "M77", "M201", "M203", "M204", "M205", "M486", "M900"})
    taken.emplace_back(word);
  expectAllKnownOrRefused("gcode", lines, plainGcode, kDuringPrint, taken);
}

TEST(Words, AreAcceptedOnlyAtTheirPlaces) {
  const struct {
    std::string_view format;
    std::string (*program)(const std::string&, const std::string&, const std::string&);
    const char* line;
    bool head, middle, end;
  } cases[] = {
      {"urscript", urscript, "set_payload(1.0,[0,0,0])\n", true, false, false},
      {"urscript", urscript, "set_gravity([0,0,9.82])\n", true, false, false},
      {"urscript", urscript, "set_gravity([0,9.82,0])\n", false, false, false},
      {"urscript", urscript, "set_analog_outputdomain(0,1)\n", true, false, false},
      {"urscript", urscript, "popup(\"go?\",blocking=True)\n", true, false, true},
      {"urscript", urscript, "set_standard_digital_out(3,True)\n", true, false, true},
      {"urscript", urscript, "stopl(1.0)\n", true, false, true},
      {"rapid", rapid, "AccSet 100,100;\n", true, false, false},
      {"rapid", rapid, "AccSet 20,100;\n", false, false, false},
      {"rapid", rapid, "VelSet 100,5000;\n", true, false, false},
      {"rapid", rapid, "SingArea\\Off;\n", true, false, false},
      {"rapid", rapid, "SingArea\\Wrist;\n", false, false, false},
      {"rapid", rapid, "SetDO doFan,1;\n", true, false, true},
      {"rapid", rapid, "UIMsgBox \"go\";\n", true, false, true},
      {"krl", krl, "HALT\n", true, false, true},
      {"krl", krl, "$ADVANCE=3\n", true, false, false},
      {"krl", krl, "$OUT[3]=TRUE\n", true, false, true},
      {"krl", krl, "$OV_PRO=50\n", false, false, false},
      {"krl", krl, "MsgNotify(\"here\")\n", true, true, true},
      {"spel", spelplus, "Pause\n", true, false, true},
      {"spel", spelplus, "Weight 1\n", true, false, false},
      {"spel", spelplus, "On 3\n", true, false, true},
      {"spel", spelplus, "AutoLJM On\n", true, false, false},
      {"melfa", melfa, "Accel 100,100\n", true, true, true},
      {"melfa", melfa, "Accel 20,100\n", false, false, false},
      {"melfa", melfa, "Hlt\n", true, false, true},
      {"melfa", melfa, "Servo On\n", true, false, true},
      {"melfa", melfa, "Fine 100\n", true, false, false},
      {"melfa", melfa, "M_Out(3)=1\n", true, false, true},
      {"melfa", melfa, "Base P_NBase\n", true, true, true},
      {"melfa", melfa, "Base (0,0,1,0,0,0)\n", false, false, false},
      {"tmscript", tmscript, "ChangeBase(\"RobotBase\")\n", true, true, true},
      {"tmscript", tmscript, "ChangeBase(\"table\")\n", false, false, false},
      {"tmscript", tmscript, "ChangeLoad(1.5)\n", true, true, true},
      {"tmscript", tmscript, "ChangeLoad(2)\n", false, false, false},
      {"tmscript", tmscript, "ListenSend(90,\"Go on?\")\nPause()\n", true, false, true},
      {"tmscript", tmscript, "Pause()\n", false, false, false},
      {"tmscript", tmscript, "IO[\"ControlBox\"].DO[3]=1\n", true, false, true},
      {"tmscript", tmscript, "WaitQueueTag(1,100)\n", true, false, true},
      {"gcode-extended", gcode, "G28\n", true, false, false},
      {"gcode-extended", gcode, "M84\n", false, false, true},
      {"gcode-extended", gcode, "M104 S210\n", true, false, true},
      {"gcode-extended", gcode, "M104 S400\n", false, false, false},
      {"gcode-extended", gcode, "T1\n", false, false, false},
      {"gcode", plainGcode, "G28\n", true, false, false},
      {"gcode", plainGcode, "G29\n", true, false, false},
      {"gcode", plainGcode, "M141 S30\n", true, false, true},
      {"gcode-bc", tableGcode, "G28\n", true, false, false},
      {"gcode-bc", tableGcode, "M106 S9\n", true, true, true},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.line);
    EXPECT_EQ(read(c.format, c.program(c.line, "", "")).defects.empty(), c.head);
    EXPECT_EQ(read(c.format, c.program("", c.line, "")).defects.empty(), c.middle);
    const plan::ReadProgram atEnd = read(c.format, c.program("", "", c.line));
    // Heat at the end is no end.
    EXPECT_EQ(atEnd.defects.empty(), c.end && c.line != std::string("M104 S210\n"));
  }
}

// A port, a signal, a tool and an output's value are whole numbers: a controller refuses others, or
// takes the next one.
TEST(Words, NumbersOfPortsAreWhole) {
  const std::string opened = "socket_open(\"192.168.0.30\",5000,\"extruder\")\n"
                             "socket_send_string(\"G0n\",\"extruder\")\n";
  const struct {
    const char* format;
    std::string (*program)(const std::string&, const std::string&, const std::string&);
    std::string good;
    std::vector<std::string> bad;
  } cases[] = {
      {"urscript",
       urscript,
       "set_standard_digital_out(5,True)\n",
       {"set_standard_digital_out(5.3,True)\n", "set_standard_digital_out(0.3,False)\n",
        "set_standard_analog_out(0.5,0)\n", "set_configurable_digital_out(1.5,True)\n"}},
      {"urscript",
       urscript,
       "while (get_standard_digital_in(5)!=True):\nsync()\nend\n",
       {"while (get_standard_digital_in(5.3)!=True):\nsync()\nend\n",
        "while (get_configurable_digital_in(0.5)!=True):\nsync()\nend\n"}},
      {"urscript",
       urscript,
       opened + "socket_send_string(\"G0n\",\"extruder\")\n",
       {opened + "socket_send_string(\"G0n\",\"other\")\n",
        "socket_send_string(\"G0n\",\"extruder\")\n",
        opened + "socket_open(\"192.168.0.30\",5000,\"other\")\n" +
            "socket_send_string(\"G0n\",\"other\")\n",
        opened + "socket_open(\"192.168.0.31\",5000,\"extruder\")\n" +
            "socket_send_string(\"G0n\",\"extruder\")\n",
        opened + "socket_close(\"extruder\")\nsocket_send_string(\"G0n\",\"extruder\")\n",
        "socket_open(5000,\"extruder\")\n", "socket_open(\"192.168.0.30\",5000.3)\n"}},
      {"rapid",
       rapid,
       "SetDO doMark1,1;\n",
       {"SetDO doMark1,0.5;\n", "SetDO doMark1,2;\n", "SetDO doExtruder,0.5;\n"}},
      {"rapid", rapid, "WaitDI diMark1,1;\n", {"WaitDI diMark1,0.5;\n", "WaitDI diMark1,2;\n"}},
      {"krl", krl, "$OUT[6]=TRUE\n", {"$OUT[6.3]=TRUE\n", "$OUT[6]=0.5\n", "$ANOUT[1.5]=0.1\n"}},
      {"krl", krl, "WAIT FOR $IN[6]==TRUE\n", {"WAIT FOR $IN[6.3]==TRUE\n"}},
      {"krl", krl, "BAS (#TOOL,0)\n", {"BAS (#TOOL,0.3)\n"}},
      {"spel", spelplus, "  On 6\n", {"  On 6.3\n", "  Off 1.3\n", "  AIO_Out 1.3, 1\n"}},
      {"spel", spelplus, "  Wait Sw(6) = On\n", {}},
      {"spel",
       spelplus,
       "  OpenNet #201 As Client\n  Write #201, \"G0n\"\n  Write #201, \"G0n\"\n",
       {"  OpenNet #201 As Client\n  Write #201.3, \"G0n\"\n",
        "  OpenNet #201 As Client\n  OpenNet #202 As Client\n"
        "  Write #201, \"G0n\"\n  Write #202, \"G0n\"\n",
        "  Write #201, \"G0n\"\n", "  OpenNet #202 As Client\n  Write #201, \"G0n\"\n",
        "  OpenNet #201 As Client\n  CloseNet #201\n  Write #201, \"G0n\"\n"}},
      {"melfa", melfa, "M_Out(8)=1\n", {"M_Out(8.3)=1\n", "M_Out(8)=0.5\n", "M_Out(10.3)=0\n"}},
      {"melfa", melfa, "Wait M_In(8)=1\n", {"Wait M_In(8.3)=1\n", "Wait M_In(8)=0.5\n"}},
      {"melfa",
       melfa,
       "Open \"COM1:\" As #1\nPrint #1,\"x\"\nClose #1\n",
       {"Open \"COM1:\" As #1\nPrint #2,\"x\"\n", "Open \"COM1:\" As #1.5\nPrint #1.5,\"x\"\n"}},
      {"tmscript",
       tmscript,
       "IO[\"ControlBox\"].DO[5]=1\n",
       {"IO[\"ControlBox\"].DO[5.3]=1\n", "IO[\"ControlBox\"].DO[5]=0.5\n",
        "IO[\"ControlBox\"].DO[0.3]=0\n", "IO[\"ControlBox\"].AO[0.3]=1\n"}},
      {"tmscript",
       tmscript,
       "while(IO[\"ControlBox\"].DI[5]==0){Sleep(10)}\n",
       {"while(IO[\"ControlBox\"].DI[5.3]==0){Sleep(10)}\n",
        "while(IO[\"ControlBox\"].DI[5]==0.5){Sleep(10)}\n"}},
      {"gcode-extended",
       gcode,
       "M106 P0 S255\n",
       {"M106 P0.3 S255\n", "M104 T0.3 S210\n", "T0.3\n"}},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(std::string(c.format) + ": " + c.good);
    const plan::ReadProgram sound = read(c.format, c.program(c.good, "", ""));
    for (const auto& d : sound.defects)
      ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
    for (const std::string& bad : c.bad)
      EXPECT_FALSE(read(c.format, c.program(bad, "", "")).defects.empty()) << bad;
  }
}

TEST(Words, OfATableAreUniqueAndHaveAMeaning) {
  for (const auto table : {urscriptWords(), rapidWords(), gcodeWords(), slicerWords(), krlWords(),
                           spelplusWords(), melfaWords(), tmscriptWords()})
    for (const KnownWord& row : table) {
      EXPECT_EQ(findWord(table, row.word), &row) << row.word << " stands twice";
      EXPECT_NE(row.places, 0) << row.word;
      EXPECT_FALSE(row.meaning.empty()) << row.word;
    }
}

TEST(Words, WaitsLetMaterialFlow) {
  const plan::ReadProgram ur = read("urscript", urscript("", "sleep(600)\n", ""));
  ASSERT_EQ(ur.pauses.size(), 1u);
  EXPECT_EQ(ur.pauses[0].before, 2u);
  EXPECT_EQ(ur.pauses[0].durationS, 600.0);
  EXPECT_DOUBLE_EQ(ur.pauses[0].volumeMm3, 600.0 * 0.1 * 40.0);
  const plan::ReadProgram abb = read("rapid", rapid("", "WaitTime\\InPos,2;\n", ""));
  ASSERT_EQ(abb.pauses.size(), 1u);
  EXPECT_DOUBLE_EQ(abb.pauses[0].volumeMm3, 2.0 * 0.1 * 40.0);
  const plan::ReadProgram g = read("gcode-extended", gcode("", "G4 P1500\n", ""));
  ASSERT_EQ(g.pauses.size(), 1u);
  EXPECT_DOUBLE_EQ(g.pauses[0].durationS, 1.5);
  EXPECT_EQ(g.pauses[0].volumeMm3, 0.0);
}

TEST(Words, FilamentDrawnOutOfTheHotEndIsADefect) {
  EXPECT_TRUE(read("gcode-extended", gcode("", "G1 E-5 F1800\nG1 E0.2\n", "")).defects.empty());
  const plan::ReadProgram far = read("gcode-extended", gcode("", "G1 E-400 F1800\nG1 E0.2\n", ""));
  ASSERT_EQ(far.defects.size(), 1u);
  EXPECT_EQ(far.defects[0].line, kDuringPrint);
}

} // namespace
} // namespace voluta::program
