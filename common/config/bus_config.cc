#include "config/bus_config.h"

namespace geon::config {

std::string ReadBusUrl(const DaemonArguments& arguments, YamlSection bus) {
  std::string url;
  bus.Read("url", &url);
  bus.Check(url.find("://") != std::string::npos, "url",
            "must be an LCM URL such as udpm://239.255.76.67:7667?ttl=0");
  return arguments.lcm_url.empty() ? url : arguments.lcm_url;
}

}  // namespace geon::config
