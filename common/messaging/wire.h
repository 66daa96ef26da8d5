#pragma once

#include "base/status.h"
#include "geon/base_command_t.hpp"
#include "geon/base_state_t.hpp"
#include "geon/bumper_t.hpp"
#include "geon/health_t.hpp"
#include "geon/image_t.hpp"
#include "geon/infrared_t.hpp"
#include "geon/laser_state_t.hpp"
#include "geon/planner_state_t.hpp"
#include "geon/ptu_command_t.hpp"
#include "geon/ptu_state_t.hpp"
#include "geon/range_profile_t.hpp"
#include "geon/scan_command_t.hpp"
#include "geon/scan_plan_t.hpp"
#include "geon/session_t.hpp"
#include "geon/sonar_t.hpp"
#include "geon/stripe_t.hpp"
#include "geon/target_mask_t.hpp"
#include "geon/target_view_t.hpp"
#include "geon/verdict_t.hpp"
#include "sensor/base.h"
#include "sensor/geon_verdict.h"
#include "sensor/health.h"
#include "sensor/image.h"
#include "sensor/laser_state.h"
#include "sensor/planner_state.h"
#include "sensor/ptu.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"
#include "sensor/target_mask.h"
#include "sensor/target_view.h"

namespace geon::messaging {

// Plain data <-> generated LCM types, one pair of overloads per message. ToWire throws
// ContractViolation for data no message can carry. FromWire refuses what plain data must not hold:
// enumerations out of range, parallel arrays of different lengths, images whose bytes are not
// height x stride.

geon::image_t ToWire(const sensor::Image& image);
geon::stripe_t ToWire(const sensor::Stripe& stripe);
geon::scan_command_t ToWire(const sensor::ScanCommand& command);
geon::scan_plan_t ToWire(const sensor::ScanPlan& plan);
geon::range_profile_t ToWire(const sensor::RangeProfile& profile);
geon::verdict_t ToWire(const sensor::GeonVerdict& verdict);
geon::ptu_state_t ToWire(const sensor::PtuState& state);
geon::ptu_command_t ToWire(const sensor::PtuCommand& command);
geon::base_state_t ToWire(const sensor::BaseState& state);
geon::base_command_t ToWire(const sensor::BaseCommand& command);
geon::sonar_t ToWire(const sensor::SonarScan& scan);
geon::bumper_t ToWire(const sensor::BumperState& state);
geon::infrared_t ToWire(const sensor::InfraredScan& scan);
geon::laser_state_t ToWire(const sensor::LaserState& state);
geon::planner_state_t ToWire(const sensor::PlannerState& state);
geon::target_mask_t ToWire(const sensor::TargetMask& mask);
geon::target_view_t ToWire(const sensor::TargetView& view);
geon::health_t ToWire(const sensor::Health& health);
geon::session_t ToWire(const sensor::Session& session);

Result<sensor::Image> FromWire(const geon::image_t& image);
Result<sensor::Stripe> FromWire(const geon::stripe_t& stripe);
Result<sensor::ScanCommand> FromWire(const geon::scan_command_t& command);
Result<sensor::ScanPlan> FromWire(const geon::scan_plan_t& plan);
Result<sensor::RangeProfile> FromWire(const geon::range_profile_t& profile);
Result<sensor::GeonVerdict> FromWire(const geon::verdict_t& verdict);
Result<sensor::PtuState> FromWire(const geon::ptu_state_t& state);
Result<sensor::PtuCommand> FromWire(const geon::ptu_command_t& command);
Result<sensor::BaseState> FromWire(const geon::base_state_t& state);
Result<sensor::BaseCommand> FromWire(const geon::base_command_t& command);
Result<sensor::SonarScan> FromWire(const geon::sonar_t& scan);
Result<sensor::BumperState> FromWire(const geon::bumper_t& state);
Result<sensor::InfraredScan> FromWire(const geon::infrared_t& scan);
Result<sensor::LaserState> FromWire(const geon::laser_state_t& state);
Result<sensor::PlannerState> FromWire(const geon::planner_state_t& state);
Result<sensor::TargetMask> FromWire(const geon::target_mask_t& mask);
Result<sensor::TargetView> FromWire(const geon::target_view_t& view);
Result<sensor::Health> FromWire(const geon::health_t& health);
Result<sensor::Session> FromWire(const geon::session_t& session);

}  // namespace geon::messaging
