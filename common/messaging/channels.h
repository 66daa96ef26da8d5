#pragma once

#include <string_view>

namespace geon::messaging {

// Every channel of the bus; docs/channels.md says who publishes what, how often and how large.
inline constexpr std::string_view kColorImage = "COLOR_IMAGE";
inline constexpr std::string_view kFloorImage = "FLOOR_IMAGE";
inline constexpr std::string_view kStripe = "STRIPE";
inline constexpr std::string_view kScanCommand = "SCAN_COMMAND";
inline constexpr std::string_view kScanPlan = "SCAN_PLAN";
inline constexpr std::string_view kTargetMask = "TARGET_MASK";
inline constexpr std::string_view kRangeProfile = "RANGE_PROFILE";
inline constexpr std::string_view kGeonVerdict = "GEON_VERDICT";
inline constexpr std::string_view kPtuState = "PTU_STATE";
inline constexpr std::string_view kPtuCommand = "PTU_COMMAND";
inline constexpr std::string_view kBaseState = "BASE_STATE";
inline constexpr std::string_view kBaseCommand = "BASE_COMMAND";
inline constexpr std::string_view kSonar = "SONAR";
inline constexpr std::string_view kBumper = "BUMPER";
inline constexpr std::string_view kInfrared = "INFRARED";
inline constexpr std::string_view kLaserState = "LASER_STATE";
inline constexpr std::string_view kPlannerState = "PLANNER_STATE";
inline constexpr std::string_view kTargetView = "TARGET_VIEW";
// Published by every process: its seq says nothing about loss.
inline constexpr std::string_view kGeonSession = "GEON_SESSION";
// HEALTH_PTU, HEALTH_COLOR_CAMERA_HEAD, ...: HealthChannel() of messaging/health_reporter.h.
inline constexpr std::string_view kHealthPrefix = "HEALTH_";
// A pattern for Bus::Subscribe: the health of every process.
inline constexpr std::string_view kAnyHealth = "HEALTH_.*";

}  // namespace geon::messaging
