#include "procs/recognizer/recognizer_node.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "messaging/channels.h"

namespace geon::recognizer {
namespace {

const char* Describe(sensor::ProfileStatus status) {
  switch (status) {
    case sensor::ProfileStatus::kOk:
      return "measured";
    case sensor::ProfileStatus::kMissing:
      return "missing";
    case sensor::ProfileStatus::kRefused:
      return "refused";
  }
  return "";
}

}  // namespace

RecognizerNode::RecognizerNode(ScanAssembler assembler, messaging::Bus* bus,
                               messaging::HealthReporter* health)
    : assembler_(std::move(assembler)), bus_(bus), health_(health) {
  bus_->Subscribe<sensor::ScanPlan>(
      messaging::kScanPlan, [this](const sensor::ScanPlan& plan) { assembler_.Take(plan); });
  bus_->Subscribe<sensor::TargetMask>(
      messaging::kTargetMask, [this](const sensor::TargetMask& mask) { assembler_.Take(mask); });
  bus_->Subscribe<sensor::Stripe>(messaging::kStripe,
                                  [this](const sensor::Stripe& stripe) { HandleStripe(stripe); });
  bus_->Subscribe<sensor::ScanCommand>(messaging::kScanCommand,
                                       [this](const sensor::ScanCommand& command) {
                                         if (const auto verdict = assembler_.Take(command))
                                           Publish(*verdict);
                                       });
  health_->SetLevel(sensor::HealthLevel::kOk);
}

void RecognizerNode::HandleStripe(const sensor::Stripe& stripe) {
  ScanAssembler::Answer answer = assembler_.Take(stripe);
  answer.profile.seq = ++profile_seq_;
  bus_->Publish(messaging::kRangeProfile, answer.profile);
  spdlog::info("stripe {} scan={} stripe={} attempt={} points={} on_target={} scan_complete={}/{}",
               Describe(answer.profile.status), stripe.scan_id, stripe.stripe_index, stripe.attempt,
               answer.profile.pixel.size(), answer.profile.on_target, assembler_.good_stripes(),
               assembler_.planned_stripes());
  if (answer.verdict) Publish(*answer.verdict);
}

void RecognizerNode::Publish(sensor::GeonVerdict verdict) {
  verdict.seq = ++verdict_seq_;
  bus_->Publish(messaging::kGeonVerdict, verdict);
  spdlog::info("verdict scan={} label={} confidence={:.2f} decided={} stripes={}", verdict.scan_id,
               ToString(verdict.label), verdict.confidence, verdict.decided,
               verdict.profiles.size());
}

}  // namespace geon::recognizer
