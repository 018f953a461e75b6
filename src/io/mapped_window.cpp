#include "io/mapped_window.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/file_descriptor.hpp"
#include "io/mapped_guard.hpp"

#include <cerrno>

#include <sys/mman.h>

namespace winnow {

namespace ipc = boost::interprocess;

namespace {

ipc::mapped_region map_region(const ipc::file_mapping& file, std::uint64_t offset,
                              std::size_t bytes) {
  try {
    return {file, ipc::read_only, static_cast<ipc::offset_t>(offset), bytes};
  } catch (const ipc::interprocess_exception& error) {
    if (error.get_native_error() == ENOMEM) {
      throw Error(ErrorKind::resources, std::string("the system has no more memory to map '") +
                                            file.get_name() + "' into");
    }
    throw Error(ErrorKind::bad_input, std::string("cannot map '") + file.get_name() + "' at byte " +
                                          grouped(offset) + ": " + error.what() +
                                          "; was it shortened while it was read?");
  }
}

}  // namespace

MappedWindow::MappedWindow(const ipc::file_mapping& file, std::uint64_t offset, std::size_t bytes)
    : region_(map_region(file, offset, bytes)) {
  // Boost's address is inside its first page; whole pages are watched from there on.
  guard_ = mapped_guard::watch(region_.get_address(), region_.get_size());
}

MappedWindow::~MappedWindow() {
  mapped_guard::forget(guard_);
}

namespace {
struct WholePages {
  void* begin;
  std::size_t bytes;
};

WholePages whole_pages(const void* address, std::size_t size) {
  const auto page = ipc::mapped_region::get_page_size();
  const auto first = reinterpret_cast<std::uintptr_t>(address) / page * page;
  const auto last = reinterpret_cast<std::uintptr_t>(address) + size;
  return {reinterpret_cast<void*>(first), last - first};
}
}  // namespace

void MappedWindow::drop_pages() const {
  const auto pages = whole_pages(region_.get_address(), region_.get_size());
  ::madvise(pages.begin, pages.bytes, MADV_DONTNEED);
}

bool MappedWindow::damaged() const {
  return mapped_guard::was_hit(guard_);
}

ipc::file_mapping map_file(const std::string& path) {
  try {
    return {path.c_str(), ipc::read_only};
  } catch (const ipc::interprocess_exception& error) {
    throw Error(cannot_open(error.get_native_error()),
                "cannot open '" + path + "': " + error.what());
  }
}

}  // namespace winnow
