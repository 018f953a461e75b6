#include "viewer/page_server.hpp"

#include <winnow/error.hpp>

#include "viewer/byte_range.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

namespace winnow::viewer {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::use_awaitable;
using asio::ip::tcp;

constexpr std::chrono::seconds idle_at_most{60}, hanging_up_at_most{2};
constexpr std::chrono::milliseconds between_looks{100};
constexpr std::size_t piece_bytes = std::size_t{1} << 18;
constexpr std::size_t unread_at_most = std::size_t{1} << 24;
constexpr unsigned http_1_1 = 11;

// What a path in an address may hold as it is; all else becomes %20 and the like.
std::string escaped(const std::string& name, const std::string& percent) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string out;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= '0' && byte <= '9') || byte == '.' || byte == '-' || byte == '_';
    if (plain) {
      out += letter;
    } else {
      out += percent;
      out += digits[byte >> 4];
      out += digits[byte & 15];
    }
  }
  return out;
}

}  // namespace

struct PageServer::State {
  State(std::string_view shown_page, std::vector<ShownFile> shown_files)
      : page(shown_page), files(std::move(shown_files)), acceptor(io), timer(io) {
    for (std::size_t i = 0; i < files.size(); ++i)
      targets.push_back("/" + std::to_string(i) + "/" + escaped(files[i].shown(), "%"));
  }

  using Parser = http::request_parser<http::empty_body>;
  using Request = Parser::value_type;
  using Response = http::response<http::buffer_body>;

  asio::awaitable<void> accept() {
    for (;;) {
      beast::error_code error;
      tcp::socket socket =
          co_await acceptor.async_accept(asio::redirect_error(use_awaitable, error));
      if (error == asio::error::operation_aborted) co_return;
      if (!error)
        asio::co_spawn(io, answer_all(beast::tcp_stream(std::move(socket))), asio::detached);
    }
  }

  // Of one connection, until the browser has no more.
  asio::awaitable<void> answer_all(beast::tcp_stream stream) {
    try {
      beast::flat_buffer buffer;
      for (bool more = true; more;) {
        stream.expires_after(idle_at_most);
        Parser parser;
        beast::error_code error;
        co_await http::async_read_header(stream, buffer, parser,
                                         asio::redirect_error(use_awaitable, error));
        more = error ? co_await refuse_unread(stream, error) : co_await answer(stream, parser);
      }
      co_await hang_up(stream);
    } catch (const std::exception&) {
      // The browser went away.
    }
  }

  // False where the connection ends with it.
  asio::awaitable<bool> answer(beast::tcp_stream& stream, const Parser& parser) {
    const Request& request = parser.get();
    if (!asked_here(request)) co_return co_await refuse(stream, request, http::status::forbidden);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      co_return co_await refuse(stream, request, http::status::method_not_allowed);
    if (!parser.is_done())  // it has a body, which nothing here needs
      co_return co_await refuse(stream, request, http::status::payload_too_large);
    const std::string target(request.target());
    const std::string path = target.substr(0, target.find('?'));
    if (path == "/") {
      Response response = response_for(request, http::status::ok, "text/html; charset=utf-8");
      co_return co_await send(stream, request, response, {0, page.size(), true},
                              [this](std::uint64_t at, std::span<char> into) {
                                return page.copy(into.data(), into.size(),
                                                 static_cast<std::size_t>(at));
                              });
    }
    const auto found = std::find(targets.begin(), targets.end(), path);
    if (found == targets.end()) co_return co_await refuse(stream, request, http::status::not_found);
    const ShownFile& file = files[static_cast<std::size_t>(found - targets.begin())];
    co_return co_await send_file(stream, request, file);
  }

  asio::awaitable<bool> send_file(beast::tcp_stream& stream, const Request& request,
                                  const ShownFile& file) {
    const std::string bytes = std::to_string(file.bytes());
    const std::optional<ByteRange> range = byte_range(
        {request[http::field::range].data(), request[http::field::range].size()}, file.bytes());
    if (!range) {
      Response none = response_for(request, http::status::range_not_satisfiable, "text/plain");
      none.set(http::field::content_range, "bytes */" + bytes);
      co_return co_await send(stream, request, none, {}, {});
    }
    Response response =
        response_for(request, range->whole ? http::status::ok : http::status::partial_content,
                     "application/octet-stream");
    response.set(http::field::accept_ranges, "bytes");
    if (!range->whole) {
      response.set(http::field::content_range, "bytes " + std::to_string(range->begin) + "-" +
                                                   std::to_string(range->end - 1) + "/" + bytes);
    }
    co_return co_await send(
        stream, request, response, *range,
        [&file](std::uint64_t at, std::span<char> into) { return file.read(at, into); });
  }

  // Another site may have its name lead here: its pages are to read nothing.
  [[nodiscard]] bool asked_here(const Request& request) const {
    const auto host = request[http::field::host];
    return host == authority || host == "localhost" + authority.substr(authority.find(':'));
  }

  static Response response_for(const Request& request, http::status status, const char* type) {
    Response response{status, http_1_1};
    response.set(http::field::content_type, type);
    response.set(http::field::cache_control, "no-store");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    response.keep_alive(request.keep_alive());
    return response;
  }

  // Without a body. What a request brought of its own is not read, so the connection ends.
  static asio::awaitable<bool> refuse(beast::tcp_stream& stream, const Request& request,
                                      http::status status) {
    Response response = response_for(request, status, "text/plain");
    response.keep_alive(false);
    if (status == http::status::method_not_allowed) response.set(http::field::allow, "GET, HEAD");
    co_return co_await send(stream, request, response, {}, {});
  }

  // What is no request, or too long for one.
  static asio::awaitable<bool> refuse_unread(beast::tcp_stream& stream,
                                             const beast::error_code& error) {
    if (error == http::error::end_of_stream) co_return false;
    if (error.category() != beast::error_code(http::error::bad_method).category())
      throw boost::system::system_error(error);  // nobody is there any more
    http::status status = http::status::bad_request;
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
      status = http::status::request_header_fields_too_large;
    else if (error == http::error::body_limit)
      status = http::status::payload_too_large;
    co_return co_await refuse(stream, {}, status);
  }

  // Takes in some of what is unread: hanging up on it would take the answer back.
  static asio::awaitable<void> hang_up(beast::tcp_stream& stream) {
    stream.socket().shutdown(tcp::socket::shutdown_send);
    stream.expires_after(hanging_up_at_most);
    std::vector<char> piece(piece_bytes);
    for (std::size_t taken = 0; taken < unread_at_most;)
      taken += co_await stream.async_read_some(asio::buffer(piece), use_awaitable);
  }

  using Read = std::function<std::size_t(std::uint64_t at, std::span<char> into)>;

  static asio::awaitable<bool> send(beast::tcp_stream& stream, const Request& request,
                                    Response& response, ByteRange range, const Read& read) {
    response.content_length(range.end - range.begin);
    response.body().data = nullptr;
    response.body().more = range.end > range.begin;
    http::response_serializer<http::buffer_body> serializer(response);
    co_await http::async_write_header(stream, serializer, use_awaitable);
    if (request.method() == http::verb::head) co_return response.keep_alive();
    std::vector<char> piece(
        static_cast<std::size_t>(std::min<std::uint64_t>(piece_bytes, range.end - range.begin)));
    while (range.begin < range.end) {
      const auto wanted =
          static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), range.end - range.begin));
      const std::size_t got = read(range.begin, std::span(piece).first(wanted));
      if (got == 0) co_return false;
      range.begin += got;
      stream.expires_after(idle_at_most);
      co_await asio::async_write(stream, asio::buffer(piece.data(), got), use_awaitable);
    }
    co_return response.keep_alive();
  }

  asio::awaitable<void> watch(std::function<bool()> ended) {
    while (!ended()) {
      timer.expires_after(between_looks);
      co_await timer.async_wait(use_awaitable);
    }
    io.stop();
  }

  std::string_view page;
  std::vector<ShownFile> files;
  std::vector<std::string> targets;
  std::string authority;
  asio::io_context io{1};
  tcp::acceptor acceptor;
  asio::steady_timer timer;
};

PageServer::PageServer(std::string_view page, std::vector<ShownFile> files, std::uint16_t port)
    : state_(std::make_unique<State>(page, std::move(files))) {
  try {
    const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
    state_->acceptor.open(endpoint.protocol());
    state_->acceptor.set_option(tcp::acceptor::reuse_address(true));
    state_->acceptor.bind(endpoint);
    state_->acceptor.listen();
    state_->authority = "127.0.0.1:" + std::to_string(state_->acceptor.local_endpoint().port());
  } catch (const boost::system::system_error& error) {
    throw Error(ErrorKind::failed, "port " + std::to_string(port) + " cannot be served: " +
                                       error.code().message() + "; --port 0 takes a free one");
  }
}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  std::string address = "http://" + state_->authority + "/";
  constexpr std::array<const char*, 2> names{"?mesh=", "&beside="};
  for (std::size_t i = 0; i < state_->files.size(); ++i) {
    // The page takes the escapes of its address off once.
    address += names[i] + std::to_string(i) + "/" + escaped(state_->files[i].shown(), "%25");
  }
  return address;
}

void PageServer::run(const std::function<bool()>& ended) {
  asio::co_spawn(state_->io, state_->accept(), asio::detached);
  asio::co_spawn(state_->io, state_->watch(ended), asio::detached);
  state_->io.run();
}

}  // namespace winnow::viewer
