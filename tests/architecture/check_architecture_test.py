#!/usr/bin/python3
"""The checker finds every kind of violation in a bad tree, and nothing in a good one."""

import pathlib
import tempfile
import unittest

import check_architecture

GOOD = {
    "ARCHITECTURE.md": """
| process | runs on |
|---|---|
| `geon-planner` | workstation |
| `geon-sim` | anywhere |

## Rooms
| room | P | what is in it | may use |
|---|---|---|---|
| `base` | P | contracts | |
| `sensor` | P | data | base |
| `attention` | P | blobs | base sensor |
| `sim` | P* | world | base |
| `messaging` | | bus | base sensor |
| `device` | | serial | base sensor |

## Safety
""",
    "common/attention/CMakeLists.txt": "geon_room(attention DEPENDS base sensor LINK opencv_core)",
    "common/attention/blobs.h": """
// Source: thesis section 4.1, equation 4.1.
#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>
#include "sensor/image.h"
struct BlobOptions {
  double smallest_area_px = 4.0, border_px{2.0};  // a double comment: ignored;
  std::vector<double> edges_m;
  int count = 3;
  double Area() const;
};
""",
    "common/attention/blobs.cc": '// never std::cout here\n#include "attention/blobs.h"\n',
    "tests/common/attention/blobs_test.cc": "",
    "common/sensor/image.h": "",
    "common/sim/world.h": "#include <embree3/rtcore.h>\n",
    "common/device/serial.h": "#include <termios.h>\n",
    "common/messaging/channels.h": 'inline constexpr std::string_view kStripe = "STRIPE";\n',
    "docs/channels.md": "STRIPE: a stripe. [frames](../README.md)",
    "README.md": "`common/attention/blobs.h`",
    "lcmtypes/geon_stripe_t.lcm": "struct stripe_t { int64_t utime;\n  double pan_rad; // any\n  double range_m[16];\n }",
    "procs/planner/CMakeLists.txt": "geon_program(geon-planner LINK geon_attention)",
    "procs/planner/main.cc": "int main(int argc, char** argv) {\n  return Run(argc, argv);\n}\n",
    "procs/simulator/CMakeLists.txt": "geon_program(geon-sim LINK geon_sim)",
    "procs/simulator/world_loop.h": '#include "sim/world.h"\n',
}


class CheckArchitectureTest(unittest.TestCase):
    def violations(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**GOOD, **changes.get("files", {})}.items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_architecture.violations(folder)

    def assert_found(self, files, *words):
        found = self.violations(files=files)
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_good_tree_is_good(self):
        self.assertEqual(self.violations(), [])

    def test_include_outside_the_table(self):
        self.assert_found({"common/sensor/image.h": '#include "attention/blobs.h"\n'},
                          "common/sensor/image.h:1", "sensor may not use attention")

    def test_room_that_includes_a_program(self):
        self.assert_found({"common/device/serial.h": '#include "procs/planner/node.h"\n'}, "procs/planner/node.h")

    def test_lcmtypes_outside_messaging(self):
        self.assert_found({"common/device/serial.h": "#include <geon/stripe_t.hpp>\n"}, "only messaging")

    def test_link_outside_the_table(self):
        self.assert_found({"common/attention/CMakeLists.txt": "geon_room(attention DEPENDS base sim)"}, "sim")
        self.assert_found({"common/attention/CMakeLists.txt": "geon_room(attention LINK geon_sim)"}, "sim")

    def test_cycle_in_the_table(self):
        table = GOOD["ARCHITECTURE.md"].replace("| data | base |", "| data | base attention |")
        self.assert_found({"ARCHITECTURE.md": table}, "cycle")

    def test_room_that_is_not_in_the_table(self):
        self.assert_found({"common/plumbing/pipe.h": ""}, "common/plumbing")

    def test_impure_includes(self):
        for header in ("<iostream>", "<fstream>", "<lcm/lcm-cpp.hpp>", "<opencv2/videoio.hpp>", "<opencv2/opencv.hpp>",
                       "<opencv2/highgui.hpp>", "<unistd.h>", "<termios.h>", "<thread>", "<chrono>", "<boost/asio.hpp>"):
            with self.subTest(header):
                self.assert_found({"common/sensor/image.h": f"#include {header}\n"}, "pure room")

    def test_impure_words(self):
        for word in ("std::random_device d;", "std::cerr << 1;", 'std::printf("x");', 'getenv("HOME");',
                     "std::filesystem::exists(p);"):
            with self.subTest(word):
                self.assert_found({"common/sim/world.h": word}, "pure room")

    def test_embree_outside_sim(self):
        self.assert_found({"common/sensor/image.h": "#include <embree3/rtcore.h>\n"}, "embree3")

    def test_impure_codec(self):
        self.assert_found({"common/device/ptu_codec.h": "#include <termios.h>\n"}, "ptu_codec.h")

    def test_daemon_that_uses_sim(self):
        self.assert_found({"procs/planner/node.h": '#include "sim/world.h"\n'}, "may use sim")

    def test_simulator_that_uses_the_bus(self):
        self.assert_found({"procs/simulator/world_loop.h": '#include "messaging/bus.h"\n'}, "simulator")

    def test_source_without_test(self):
        self.assert_found({"common/sensor/image.cc": ""}, "tests/common/sensor/image_test.cc")

    def test_thesis_header_without_source(self):
        self.assert_found({"common/attention/mask.h": "// a mask\n"}, "Source:")

    def test_message_field_without_unit(self):
        self.assert_found({"lcmtypes/geon_x_t.lcm": "struct x_t {\n  double range;\n}"}, "range")
        self.assert_found({"lcmtypes/geon_x_t.lcm": "struct x_t {\n  float ranges[3];\n}"}, "ranges")

    def test_option_without_unit(self):
        for field in ("double speed = 1.0;", "float gain;", "std::vector<double> limits;", "double a_m = 0.0, b = 1.0;",
                      "std::array<double, 3> weights{};"):
            with self.subTest(field):
                self.assert_found({"common/device/serial.h": f"struct LineOptions {{\n  {field}\n}};"}, "no unit")

    def test_long_main(self):
        self.assert_found({"procs/planner/main.cc": "int main() {\n" + "  f();\n" * 31 + "}\n"}, "main()")

    def test_long_file(self):
        self.assert_found({"common/sensor/image.h": "\n" * 401}, "401 lines")

    def test_names_that_say_nothing(self):
        self.assert_found({"common/sensor/string_utils.h": ""}, "string_utils.h")
        self.assert_found({"procs/planner/util/text.h": ""}, "util/text.h")

    def test_unfinished_work(self):
        self.assert_found({"common/sensor/image.h": "// TO" + "DO: more\n"}, "unfinished")

    def test_channel_that_is_not_documented(self):
        self.assert_found({"docs/channels.md": "nothing"}, "STRIPE")

    def test_program_that_is_not_in_the_table(self):
        self.assert_found({"procs/viewer/CMakeLists.txt": "geon_program(geon-viewer)"}, "geon-viewer")

    def test_broken_link(self):
        self.assert_found({"README.md": "[map](docs/map.md)"}, "docs/map.md")
        self.assert_found({"README.md": "see `common/attention/gone.h`"}, "gone.h")


if __name__ == "__main__":
    unittest.main()
