// Serves a page and a stream of bytes to browsers on this computer, over HTTP.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace labmouse {

/// What is served, and to whom.
struct PageServerOrder {
  std::string host = "127.0.0.1";  ///< the IPv4 address of this computer that accepts connections
  std::string token;               ///< nobody may guess it; it is the folder in all addresses
  std::string page;                ///< HTML that passes wrong_live_page()
  std::string begin;               ///< JSON of the call `live_begin`
  int patience = 5000;             ///< ms that a client may take for a request, and for taking the page
};

/// What is wrong with the text of a page, or nothing. The page must have one place for the address that it may read.
std::string wrong_live_page(std::string_view page);

/// A server without threads: it works while serve() runs. It answers GET of three addresses in the folder of the
/// token: the page, `begin`, and `lines`, a response that goes on until end(). It refuses requests that name another
/// host, because a foreign page may have a name that leads here.
class PageServer {
 public:
  static constexpr std::size_t most_clients = 16;
  static constexpr std::size_t most_request = 8192;  ///< bytes
  /// Bytes of the stream for clients that come late: the newest ones, from the begin of a line.
  static constexpr std::size_t most_kept = std::size_t{1} << 22U;

  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;
  ~PageServer();

  /// Answers all that is ready. Waits at most that many milliseconds for the first of it.
  void serve(int milliseconds);
  /// Sends bytes to all readers of the stream, now and in the next calls of serve(). A reader that is so slow that
  /// they are no longer kept is disconnected.
  void add(std::string_view bytes);
  /// Ends the stream; those who come later still get it.
  void end();

  std::uint16_t port() const;
  /// The address of the page.
  std::string link() const;

 private:
  struct State;
  explicit PageServer(std::unique_ptr<State> state);
  friend struct OpenedServer open_page_server(PageServerOrder order);
  std::unique_ptr<State> state_;
};

/// A server, or why there is none: exactly one of the two is there.
struct OpenedServer {
  std::unique_ptr<PageServer> server;
  std::string error;
};

/// Listens on a free port.
OpenedServer open_page_server(PageServerOrder order);

}  // namespace labmouse
