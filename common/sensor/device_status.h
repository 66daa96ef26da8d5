#pragma once

namespace geon::sensor {

// What a daemon knows of its device. Until a device has been initialised and answers in step, its
// state is kUnknown and nobody may act on the numbers beside it.
enum class DeviceStatus { kUnknown = 0, kStarting = 1, kReady = 2, kFault = 3 };

}  // namespace geon::sensor
