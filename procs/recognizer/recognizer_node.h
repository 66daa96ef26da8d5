#pragma once

#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "procs/recognizer/scan_assembler.h"

namespace geon::recognizer {

// Wires a scan assembler to the bus: SCAN_PLAN, TARGET_MASK, STRIPE and SCAN_COMMAND in,
// RANGE_PROFILE and GEON_VERDICT out.
class RecognizerNode {
 public:
  RecognizerNode(ScanAssembler assembler, messaging::Bus* bus, messaging::HealthReporter* health);

 private:
  void HandleStripe(const sensor::Stripe& stripe);
  void Publish(sensor::GeonVerdict verdict);

  ScanAssembler assembler_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  int32_t profile_seq_ = 0;
  int32_t verdict_seq_ = 0;
};

}  // namespace geon::recognizer
