#include "program/gcode/gcode_rapid_text.h"

namespace voluta::program {

namespace {

// ReadStr returns at most 80 characters: a longer line is read in pieces, of which the last word
// may be cut. A new G or M also ends a block, in case a line has exactly 80 characters.
constexpr std::string_view kSame = R"(  ! from here on the same for every job
  CONST zonedata zBlend:=[FALSE,0.3,0.3,0.3,1,1,1];
  CONST num nFilamentMm2:=2.405282;
  CONST num nTravelMmPerS:=100;
  VAR iodev dFile;
  VAR triggdata tFlow;
  VAR string sCode:="";
  VAR num nX:=0;
  VAR num nY:=0;
  VAR num nZ:=0;
  VAR num nToX:=0;
  VAR num nToY:=0;
  VAR num nToZ:=1;
  VAR num nE:=0;
  VAR num nLastE:=0;
  VAR num nDrawn:=0;
  VAR num nF:=0;
  VAR num nSeconds:=0;
  VAR bool bGoes:=FALSE;
  VAR bool bWaits:=FALSE;
  VAR bool bPrints:=FALSE;
  VAR bool bStands:=TRUE;
  VAR bool bOn:=FALSE;
  VAR robtarget pWaits;
  VAR pos pLast;
  VAR num nSpeed:=0;
  VAR num nShare:=0;
  VAR num nSaid:=0;

  PROC main()
    VAR string sPiece;
    VAR string sCut:="";
    VAR string sWord;
    VAR num nAt;
    VAR num nEnd;
    VAR bool bMore;
    VAR bool bRemark:=FALSE;
    ConfL\Off;
    ConfJ\Off;
    outputsOff;
    UIMsgBox "The arm goes slowly and straight to its start. Is the way clear?";
    IF bByJoints THEN
      MoveAbsJ jStart\NoEOffs,[50,20,5000,1000],fine,tNozzle\WObj:=wPlate;
    ELSE
      MoveJ pStart,[50,20,5000,1000],fine,tNozzle\WObj:=wPlate;
    ENDIF
    Open "HOME:"\File:=sFile,dFile\Read;
    sPiece:=ReadStr(dFile\RemoveCR);
    WHILE sPiece<>EOF DO
      bMore:=StrLen(sPiece)=80;
      nAt:=1;
      WHILE nAt<=StrLen(sPiece) DO
        nEnd:=StrFind(sPiece,nAt," ");
        sWord:=sCut;
        sCut:="";
        IF nEnd>nAt THEN
          sWord:=sWord+StrPart(sPiece,nAt,nEnd-nAt);
        ENDIF
        IF nEnd>StrLen(sPiece) AND bMore AND StrLen(sWord)<40 THEN
          sCut:=sWord;
        ELSEIF StrLen(sWord)>0 AND NOT bRemark THEN
          IF StrPart(sWord,1,1)=";" OR sWord="M117" THEN
            bRemark:=TRUE;
          ELSE
            takeWord sWord;
          ENDIF
        ENDIF
        nAt:=nEnd+1;
      ENDWHILE
      IF NOT bMore THEN
        IF StrLen(sCut)>0 AND NOT bRemark THEN
          takeWord sCut;
        ENDIF
        sCut:="";
        bRemark:=FALSE;
        doBlock;
      ENDIF
      sPiece:=ReadStr(dFile\RemoveCR);
    ENDWHILE
    doBlock;
    goOn FALSE;
    outputsOff;
    Close dFile;
  ENDPROC

  PROC outputsOff()
    SetDO doExtruder,0;
    SetAO aoFlow,0;
    bOn:=FALSE;
    nSaid:=0;
  ENDPROC

  PROC refuse(string sWhat)
    outputsOff;
    Close dFile;
    UIMsgBox "Not understood: "+sWhat;
    EXIT;
  ENDPROC

  PROC takeWord(string sWord)
    VAR string sLetter;
    VAR num nFirst:=2;
    VAR num nValue:=0;
    sLetter:=StrPart(sWord,1,1);
    IF sLetter="G" OR sLetter="M" THEN
      doBlock;
      sCode:=sWord;
      RETURN;
    ENDIF
    IF sLetter="n" AND StrLen(sWord)>2 THEN
      sLetter:=StrPart(sWord,1,2);
      nFirst:=3;
    ENDIF
    IF StrLen(sWord)<nFirst THEN
      refuse sWord;
    ENDIF
    IF NOT StrToVal(StrPart(sWord,nFirst,StrLen(sWord)-nFirst+1),nValue) THEN
      refuse sWord;
    ENDIF
    IF sLetter="X" THEN
      nX:=nValue;
      bGoes:=TRUE;
    ELSEIF sLetter="Y" THEN
      nY:=nValue;
      bGoes:=TRUE;
    ELSEIF sLetter="Z" THEN
      nZ:=nValue;
      bGoes:=TRUE;
    ELSEIF sLetter="nX" THEN
      nToX:=nValue;
      bGoes:=TRUE;
    ELSEIF sLetter="nY" THEN
      nToY:=nValue;
      bGoes:=TRUE;
    ELSEIF sLetter="nZ" THEN
      nToZ:=nValue;
      bGoes:=TRUE;
    ELSEIF sLetter="E" THEN
      nE:=nValue;
    ELSEIF sLetter="F" THEN
      nF:=nValue;
    ELSEIF sLetter="S" THEN
      nSeconds:=nValue;
    ELSE
      refuse sWord;
    ENDIF
  ENDPROC

  PROC doBlock()
    IF sCode="G0" OR sCode="G1" THEN
      IF bGoes THEN
        doMotion;
      ELSE
        doPush;
      ENDIF
    ELSEIF sCode="G92" THEN
      nLastE:=nE;
    ELSEIF sCode="G4" THEN
      goOn FALSE;
      WaitTime\InPos,nSeconds;
    ELSEIF sCode<>"" AND sCode<>"G21" AND sCode<>"G28" AND sCode<>"G90" AND sCode<>"M0"
      AND sCode<>"M82" AND sCode<>"M84" AND sCode<>"M104" AND sCode<>"M109"
      AND sCode<>"M106" AND sCode<>"M107" AND sCode<>"M140" AND sCode<>"M190" THEN
      refuse sCode;
    ENDIF
    sCode:="";
    bGoes:=FALSE;
  ENDPROC

  PROC doMotion()
    VAR num nOut;
    VAR num nWay;
    VAR bool bBead;
    nOut:=nE-nLastE;
    nLastE:=nE;
    bBead:=sCode="G1" AND nOut>0;
    nWay:=Distance(pLast,[nX,nY,nZ]);
    goOn bWaits AND bBead=bPrints;
    pLast:=[nX,nY,nZ];
    pWaits:=[pLast,turned(),[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    bPrints:=bBead;
    nSpeed:=nF/60;
    IF nSpeed<=0 THEN
      nSpeed:=nTravelMmPerS;
    ENDIF
    IF NOT bBead THEN
      nShare:=0;
    ELSEIF nWay>0.001 THEN
      nShare:=nOut*nFilamentMm2/nWay*nSpeed/nFullFlow;
      IF nShare>1 THEN
        nSpeed:=nSpeed/nShare;
        nShare:=1;
      ENDIF
    ENDIF
    bWaits:=TRUE;
  ENDPROC

  PROC doPush()
    VAR num nOut;
    VAR num nBack;
    nOut:=nE-nLastE;
    nLastE:=nE;
    goOn FALSE;
    IF nOut<0 THEN
      nDrawn:=nDrawn-nOut;
    ELSEIF nOut>0 THEN
      nBack:=nDrawn;
      IF nBack>nOut THEN
        nBack:=nOut;
      ENDIF
      nDrawn:=nDrawn-nBack;
      nOut:=nOut-nBack;
      IF nOut>0 AND nF>0 THEN
        nShare:=nF/60*nFilamentMm2/nFullFlow;
        nSeconds:=nOut/nF*60;
        IF nShare>1 THEN
          nSeconds:=nSeconds*nShare;
          nShare:=1;
        ENDIF
        SetAO aoFlow,nShare;
        SetDO doExtruder,1;
        WaitTime\InPos,nSeconds;
        outputsOff;
      ENDIF
    ENDIF
  ENDPROC

  PROC goOn(bool bThrough)
    VAR zonedata zUse;
    VAR speeddata vUse;
    IF NOT bWaits THEN
      RETURN;
    ENDIF
    bWaits:=FALSE;
    zUse:=fine;
    IF bThrough THEN
      zUse:=zBlend;
    ENDIF
    vUse:=[nSpeed,500,5000,1000];
    IF bOn AND NOT bPrints THEN
      SetDO doExtruder,0;
      bOn:=FALSE;
    ENDIF
    IF bPrints AND Abs(nShare-nSaid)>0.02*nSaid AND NOT bStands THEN
      TriggEquip tFlow,0\Start,0\AOp:=aoFlow,nShare;
      nSaid:=nShare;
      TriggL pWaits,vUse,tFlow,zUse,tNozzle\WObj:=wPlate;
    ELSE
      IF bPrints AND bStands THEN
        SetAO aoFlow,nShare;
        nSaid:=nShare;
      ENDIF
      IF bPrints AND NOT bOn THEN
        SetDO doExtruder,1;
        bOn:=TRUE;
      ENDIF
      MoveL pWaits,vUse,zUse,tNozzle\WObj:=wPlate;
    ENDIF
    bStands:=NOT bThrough;
  ENDPROC

  FUNC orient turned()
    VAR pos zFrom;
    VAR pos zTo;
    VAR num nCos;
    VAR pose fTurn;
    zFrom:=PoseVect([[0,0,0],pStart.rot],[0,0,1]);
    zTo:=[-nToX,-nToY,-nToZ];
    nCos:=DotProd(zFrom,zTo);
    IF nCos<-0.999 THEN
      refuse "a nozzle that points the other way than at the start";
    ENDIF
    fTurn:=PoseMult([[0,0,0],NOrient([1+nCos,zFrom.y*zTo.z-zFrom.z*zTo.y,zFrom.z*zTo.x-zFrom.x*zTo.z,zFrom.x*zTo.y-zFrom.y*zTo.x])],[[0,0,0],pStart.rot]);
    RETURN fTurn.rot;
  ENDFUNC
ENDMODULE
)";

} // namespace

std::string_view rapidGcodeSame() {
  return kSame;
}

std::string_view rapidGcodeSameBegin() {
  return kSame.substr(0, kSame.find('\n'));
}

} // namespace voluta::program
