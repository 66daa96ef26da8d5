#include "sim/ptu_commands.h"

#include <gtest/gtest.h>

namespace geon::sim {
namespace {

class PtuCommandsTest : public ::testing::Test {
 protected:
  // The reply as it would be sent, without what it waits for.
  std::string Do(const std::string& word) {
    last_ = ExecutePtuCommand(*ParsePtuWord(word), unit_);
    return (last_.ok ? "*" : "!") + (last_.text.empty() ? "" : " " + last_.text);
  }
  void Pass(double duration_s) {
    for (double t_s = 0.0; t_s < duration_s; t_s += 0.001) unit_.Step(0.001);
  }

  PtuUnit unit_{PtuUnitOptions{}};
  PtuReply last_;
};

TEST_F(PtuCommandsTest, VerboseAnswersAsTheManualPrintsThem) {
  const std::vector<std::pair<std::string, std::string>> manual = {
      {"PP", "* Current Pan position is 0"},
      {"TO", "* Target Tilt position is 0"},
      {"PR", "* 185.1428 seconds arc per Pan position"},
      {"PN", "* Minimum Pan position is -3090"},
      {"TX", "* Maximum Tilt position is 604"},
      {"PS", "* Target Pan speed is 1000 positions/sec"},
      {"PD", "* Current Pan speed is 0 positions/sec"},
      {"PA", "* Pan acceleration is 2000 positions/sec^2"},
      {"TB", "* Current Tilt base speed is 57 positions/sec"},
      {"PU", "* Maximum Pan speed is 2902 positions/sec"},
      {"PL", "* Minimum Pan speed is 31 positions/sec"},
      {"L", "* Limit bounds are ENABLED (soft limits enabled)"},
      {"PH", "* Pan hold power is REGULAR"},
      {"U", "* Unit ID is 0"},
      {"O", "* Input 30 VDC @ 86 degF"},
  };
  for (const auto& [word, reply] : manual) EXPECT_EQ(Do(word), reply) << word;
}

TEST_F(PtuCommandsTest, TerseAnswersAreBareNumbers) {
  EXPECT_EQ(Do("FT"), "*");
  EXPECT_EQ(Do("F"), "* ASCII terse mode");
  EXPECT_EQ(Do("TN"), "* -907");
  EXPECT_EQ(Do("TR"), "* 185.1428");
  EXPECT_EQ(Do("TU"), "* 2902");
}

TEST_F(PtuCommandsTest, PositionsOutsideTheBoundsAreRefusedAndNotExecuted) {
  EXPECT_EQ(Do("PP3091"), "! Maximum allowable Pan position is 3090");
  EXPECT_EQ(Do("TP-908"), "! Minimum allowable Tilt position is -907");
  EXPECT_FALSE(unit_.moving());
  EXPECT_EQ(Do("PP3090"), "*");
  EXPECT_EQ(Do("LD"), "*");
  EXPECT_EQ(Do("PP3200"), "*");
  EXPECT_EQ(Do("PP32768"), "! Illegal argument");
}

TEST_F(PtuCommandsTest, OffsetsCountFromWhereItIsNow) {
  Do("PP1000");
  Pass(3.0);
  EXPECT_EQ(Do("PO-300"), "*");
  EXPECT_EQ(Do("PO"), "* Target Pan position is 700");
  EXPECT_EQ(Do("PO2200"), "! Maximum allowable Pan position is 3090");
  Pass(3.0);
  EXPECT_EQ(Do("PP"), "* Current Pan position is 700");
}

TEST_F(PtuCommandsTest, SpeedsKeepTheirBounds) {
  EXPECT_EQ(Do("PS2903"), "! Pan speed cannot exceed 2902 positions/sec");
  EXPECT_EQ(Do("TS30"), "! Motor speed cannot be less than 31 pos/sec");
  EXPECT_EQ(Do("TS2902"), "*");
  EXPECT_EQ(Do("TD500"), "*");
  EXPECT_EQ(Do("TS"), "* Target Tilt speed is 500 positions/sec") << "from standing still";
}

TEST_F(PtuCommandsTest, TablesTakeTheirTimeAndRaisingTheCapTakesLonger) {
  EXPECT_EQ(Do("PA3000"), "*");
  EXPECT_EQ(last_.when, PtuReply::When::kTables);
  EXPECT_NEAR(last_.table_time_s, 0.8, 1e-9);
  EXPECT_EQ(Do("PA3000"), "*");
  EXPECT_EQ(last_.when, PtuReply::When::kNow) << "nothing to recompute";
  EXPECT_EQ(Do("PU5833"), "*");
  EXPECT_NEAR(last_.table_time_s, 6.0, 1e-9);
  EXPECT_EQ(Do("PS5833"), "*");
  EXPECT_EQ(Do("PU5834"), "! Pan speed cannot exceed 5833 positions/sec");
  EXPECT_EQ(Do("PU2000"), "*");
  EXPECT_EQ(Do("PS"), "* Target Pan speed is 2000 positions/sec");
  EXPECT_EQ(Do("PB30"), "! Illegal argument");
  EXPECT_EQ(Do("PB0"), "*");
  EXPECT_EQ(Do("PL10"), "! Motor speed cannot be less than 31 pos/sec");
  EXPECT_EQ(Do("PA0"), "! Illegal argument");
}

TEST_F(PtuCommandsTest, PureVelocityIsSigned) {
  EXPECT_EQ(Do("C"), "* independent control mode");
  EXPECT_EQ(Do("CV"), "*");
  EXPECT_EQ(Do("C"), "* pure velocity control mode");
  EXPECT_EQ(Do("PS-500"), "*");
  Pass(1.0);
  EXPECT_EQ(Do("PD"), "* Current Pan speed is -500 positions/sec");
  EXPECT_EQ(Do("PP100"), "! Illegal Command Entered");
  EXPECT_EQ(Do("PS-9999"), "! Pan speed cannot exceed 2902 positions/sec");
  EXPECT_EQ(Do("PS0"), "*");
  Pass(1.0);
  EXPECT_FALSE(unit_.moving());
  EXPECT_EQ(Do("CI"), "*");
  EXPECT_EQ(Do("PS"), "* Target Pan speed is 1000 positions/sec");
}

TEST_F(PtuCommandsTest, ModesAreSetAndTold) {
  EXPECT_EQ(Do("ED"), "*");
  EXPECT_EQ(Do("E"), "* Echo mode is DISABLED");
  EXPECT_EQ(Do("EE"), "*");
  EXPECT_EQ(Do("E"), "* Echo mode is ENABLED");
  EXPECT_EQ(Do("F"), "* ASCII VERBOSE mode");
  EXPECT_EQ(Do("LD"), "*");
  EXPECT_EQ(Do("L"), "* Limit bounds are DISABLED");
  EXPECT_EQ(Do("RT"), "*");
  EXPECT_EQ(unit_.settings().reset_at_power_up, (std::array<bool, 2>{false, true}));
  EXPECT_EQ(Do("U5"), "*");
  EXPECT_EQ(Do("U"), "* Unit ID is 5");
  EXPECT_EQ(Do("U-1"), "! Illegal argument");
}

TEST_F(PtuCommandsTest, PowerModesAreKeptForEachAxis) {
  EXPECT_EQ(Do("PHL"), "*");
  EXPECT_EQ(Do("THO"), "*");
  EXPECT_EQ(Do("TMH"), "*");
  EXPECT_EQ(Do("PH"), "* Pan hold power is LOW");
  EXPECT_EQ(Do("TH"), "* Tilt hold power is OFF");
  EXPECT_EQ(Do("TM"), "* Tilt move power is HIGH");
  EXPECT_EQ(Do("PM"), "* Pan move power is REGULAR");
  EXPECT_EQ(Do("PHH"), "! Illegal Command Entered") << "holding knows no high power";
}

TEST_F(PtuCommandsTest, DefaultsAreSavedRestoredAndTheFactorys) {
  Do("PS500");
  EXPECT_EQ(Do("DS"), "*");
  Do("PS800");
  EXPECT_EQ(Do("DR"), "*");
  EXPECT_EQ(Do("PS"), "* Target Pan speed is 500 positions/sec");
  EXPECT_EQ(Do("DF"), "*");
  EXPECT_EQ(Do("PS"), "* Target Pan speed is 1000 positions/sec");
}

TEST_F(PtuCommandsTest, HaltsOneAxisOrBoth) {
  Do("PP3000");
  Do("TP600");
  Pass(0.3);
  EXPECT_EQ(Do("HP"), "*");
  Pass(2.0);
  EXPECT_LT(unit_.axis(PtuAxisId::kPan).position(), 1000);
  EXPECT_EQ(unit_.axis(PtuAxisId::kTilt).position(), 600);
  Do("TP-600");
  Pass(0.3);
  EXPECT_EQ(Do("H"), "*");
  Pass(2.0);
  EXPECT_GT(unit_.axis(PtuAxisId::kTilt).position(), 0);
}

TEST_F(PtuCommandsTest, MonitorWantsTwoOrFourEndsWithinTheBounds) {
  EXPECT_EQ(Do("M1"), "! Illegal argument");
  EXPECT_EQ(Do("M-4000,100"), "! Illegal argument");
  EXPECT_EQ(Do("M-500,500,-100,100"), "*");
  EXPECT_TRUE(unit_.monitoring());
  EXPECT_EQ(Do("MQ"), "* Monitor scans -500,500,-100,100");
  EXPECT_EQ(Do("ME"), "*");
  EXPECT_TRUE(unit_.settings().monitor_at_power_up);
  EXPECT_EQ(Do("MD"), "*");
}

TEST_F(PtuCommandsTest, AwaitAndResetAnswerLater) {
  Do("S");
  Do("PP500");
  EXPECT_EQ(Do("A"), "*");
  EXPECT_EQ(last_.when, PtuReply::When::kArrived);
  EXPECT_EQ(unit_.axis(PtuAxisId::kPan).target(), 500) << "slaved moves start";
  Do("R");
  EXPECT_EQ(last_.when, PtuReply::When::kReset);
}

TEST_F(PtuCommandsTest, WhatItDoesNotKnowIsIllegal) {
  for (const char* word : {"X", "PQ", "PPP", "P", "LU", "PNU", "B", "V5", "QQ1"}) {
    EXPECT_EQ(Do(word), "! Illegal Command Entered") << word;
  }
  for (const char* word : {"PN5", "PR1", "PP1,2", "PH1"}) {
    EXPECT_EQ(Do(word), "! Illegal argument") << word;
  }
  EXPECT_NE(Do("?").find("position"), std::string::npos);
  EXPECT_NE(Do("V").find("Pan-Tilt Controller"), std::string::npos);
}

}  // namespace
}  // namespace geon::sim
