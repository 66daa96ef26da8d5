#include "sim/ptu_emulator.h"

#include <algorithm>
#include <cctype>

namespace geon::sim {
namespace {

constexpr double kPtuTick_s = 0.001;
constexpr size_t kLongestWord = 60;
constexpr size_t kMutedBytes = 100;
constexpr char kPtuBanner[] =
    "\r\n### PAN-TILT CONTROLLER v2.12.1d1\r\n### Directed Perception, Inc.\r\n*\r\n";

// "@A(9600,8,N,F)" sets one of the two expansion ports, where nothing is connected.
bool IsExpansionPortSetup(std::string_view word) {
  return word.size() > 5 && word[0] == '@' &&
         std::string_view("ABab").find(word[1]) != std::string_view::npos && word[2] == '(' &&
         word.back() == ')' && std::count(word.begin(), word.end(), ',') == 3;
}

}  // namespace

PtuEmulator::PtuEmulator(const PtuEmulatorOptions& options)
    : options_(options), unit_(options.unit), from_host_(options.baud), to_host_(options.baud) {
  if (options.starts_with_reset) {
    PowerCycle(0.0);
  } else {
    Send(kPtuBanner);
  }
}

void PtuEmulator::PowerCycle(double time_s) {
  Advance(time_s);
  word_.clear();
  muted_.clear();
  pending_.reset();
  tables_ready_s_.reset();
  from_host_.Clear();
  to_host_.Clear();
  unit_.PowerCycle();
  selected_ = unit_.settings().unit_id == 0;
  powering_up_ = true;
}

void PtuEmulator::Receive(std::span<const uint8_t> bytes, double time_s) {
  from_host_.Push(bytes, time_s);
}

std::vector<uint8_t> PtuEmulator::Transmit(double time_s) { return to_host_.PopAll(time_s); }

void PtuEmulator::Advance(double time_s) {
  while (static_cast<double>(ticks_ + 1) * kPtuTick_s <= time_s) Tick();
}

void PtuEmulator::Tick() {
  ++ticks_;
  now_s_ = static_cast<double>(ticks_) * kPtuTick_s;
  const std::string events = unit_.Step(kPtuTick_s);
  if (powering_up_) {
    // What it finds while it hunts for its stops after power-up it keeps to itself, and it is deaf.
    while (from_host_.Pop(now_s_)) {
    }
    if (unit_.resetting()) return;
    powering_up_ = false;
    Send(kPtuBanner);
    return;
  }
  Send(events);
  if (pending_) FinishPending();
  while (!pending_) {
    const auto byte = from_host_.Pop(now_s_);
    if (!byte) break;
    HandleByte(*byte);
  }
}

void PtuEmulator::HandleByte(uint8_t byte) {
  unit_.AbortMonitor();
  const char c = static_cast<char>(byte);
  if (unit_.echo && selected_) Send(std::string_view(&c, 1));
  if (c == ' ' || c == '\r' || c == '\n') {
    std::string word;
    word.swap(word_);
    if (!word.empty()) HandleWord(word);
  } else if (word_.size() <= kLongestWord) {
    word_.push_back(c);  // a longer word is no command whatever follows
  }
}

void PtuEmulator::HandleWord(const std::string& word) {
  if (IsExpansionPortSetup(word)) {
    Answer({});
    return;
  }
  const auto command = ParsePtuWord(word);
  if (command && command->letters == "_" && command->numbers.size() == 1) {
    SelectUnit(command->numbers[0]);
    return;
  }
  // A unit that is not selected listens for its selection only.
  if (!selected_) return;
  if (word.size() > kLongestWord || !command) {
    const bool has_letters = std::isalpha(static_cast<unsigned char>(word[0])) != 0;
    Answer({false,
            has_letters && word.size() <= kLongestWord ? "Illegal argument"
                                                       : "Illegal Command Entered",
            PtuReply::When::kNow, 0.0});
    return;
  }
  Answer(ExecutePtuCommand(*command, unit_));
}

void PtuEmulator::SelectUnit(int id) {
  const int own = unit_.settings().unit_id;
  selected_ = own == 0 || id == 0 || id == own;
  if (!selected_) return;
  std::string muted;
  muted.swap(muted_);
  Send(muted);
}

void PtuEmulator::Answer(const PtuReply& reply) {
  if (reply.when != PtuReply::When::kNow) {
    pending_ = reply;
    tables_ready_s_.reset();
    return;
  }
  std::string text = reply.ok ? "*" : "!";
  if (!reply.text.empty()) text += " " + reply.text;
  Send(text + "\r\n");
}

void PtuEmulator::FinishPending() {
  switch (pending_->when) {
    case PtuReply::When::kNow:
      break;
    case PtuReply::When::kArrived:
      if (unit_.moving()) return;
      break;
    case PtuReply::When::kTables:
      if (unit_.moving()) return;
      if (!tables_ready_s_) tables_ready_s_ = now_s_ + pending_->table_time_s;
      if (now_s_ < *tables_ready_s_) return;
      break;
    case PtuReply::When::kReset:
      if (unit_.resetting()) return;
      pending_.reset();
      Send(options_.reset_ends_with_newline ? "*\r\n" : "*");
      return;
  }
  PtuReply reply = *pending_;
  pending_.reset();
  reply.when = PtuReply::When::kNow;
  Answer(reply);
}

void PtuEmulator::Send(std::string_view text) {
  if (!selected_) {
    muted_.append(text.substr(0, kMutedBytes - std::min(kMutedBytes, muted_.size())));
    return;
  }
  const auto* bytes = reinterpret_cast<const uint8_t*>(text.data());
  to_host_.Push({bytes, text.size()}, now_s_ + options_.reply_latency_s);
}

}  // namespace geon::sim
