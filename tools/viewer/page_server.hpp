// Serves the page and the files that it shows to browsers on this machine, and nothing else.
#pragma once

#include "viewer/shown_file.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace winnow::viewer {

class PageServer {
 public:
  // Listens on 127.0.0.1. `port`: 0 takes any that is free. Throws Error(failed).
  PageServer(std::string_view page, std::vector<ShownFile> files, std::uint16_t port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  // Where the page is, told to show the files.
  [[nodiscard]] std::string address() const;
  // Until `ended` says so; it is asked ten times a second.
  void run(const std::function<bool()>& ended);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace winnow::viewer
