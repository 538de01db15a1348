#include "labmouse/lab/system/page_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "labmouse/lab/system/descriptor.hpp"
#include "labmouse/lab/system/file_problems.hpp"

#ifndef _WIN32
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#endif

namespace labmouse {
namespace {

/// What the page may connect to, in the policy that it carries.
constexpr std::string_view page_policy = "connect-src ws://127.0.0.1:*";
constexpr std::string_view page_head = "<head>";

}  // namespace

std::string wrong_live_page(std::string_view page) {
  const auto at = page.find(page_policy);
  if (at == std::string_view::npos || page.find(page_policy, at + 1) != std::string_view::npos ||
      page.find(page_head) == std::string_view::npos)
    return "is not a page that can read a robot";
  return {};
}

#ifdef _WIN32

struct PageServer::State {};
void PageServer::serve(int) {}
void PageServer::add(std::string_view) {}
void PageServer::end() {}
std::uint16_t PageServer::port() const { return 0; }
std::string PageServer::link() const { return {}; }
OpenedServer open_page_server(PageServerOrder) { return {nullptr, "this system cannot serve the page"}; }

#else

namespace {

using ServerClock = std::chrono::steady_clock;

#ifdef MSG_NOSIGNAL
constexpr int without_signal = MSG_NOSIGNAL;
#else
constexpr int without_signal = 0;
#endif

/// Text of a token is compared in a time that says nothing about it.
bool same_secret(std::string_view one, std::string_view other) {
  if (one.size() != other.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    difference |= static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(other[i]);
  return difference == 0;
}

/// The value of a header that stands there exactly once.
std::optional<std::string_view> header_of(std::string_view request, std::string_view name) {
  std::optional<std::string_view> found;
  const auto lower = [](char letter) { return letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter; };
  for (auto at = request.find("\r\n"); at != std::string_view::npos; at = request.find("\r\n", at)) {
    at += 2;
    const std::string_view line = request.substr(at, request.find("\r\n", at) - at);
    const auto colon = line.find(':');
    if (colon != name.size() ||
        !std::equal(name.begin(), name.end(), line.begin(), [&](char a, char b) { return a == lower(b); }))
      continue;
    if (found) return std::nullopt;
    std::string_view value = line.substr(colon + 1);
    while (value.starts_with(' ')) value.remove_prefix(1);
    while (value.ends_with(' ')) value.remove_suffix(1);
    found = value;
  }
  return found;
}

bool set_unwaiting(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  return flags >= 0 && fcntl(descriptor, F_SETFL, flags | O_NONBLOCK) == 0 &&
         fcntl(descriptor, F_SETFD, FD_CLOEXEC) == 0;
}

}  // namespace

struct PageServer::State {
  /// A connection.
  struct Client {
    Descriptor descriptor;
    ServerClock::time_point end;  ///< until then it has to be done, unless it reads the stream
    std::string request, answer;
    std::size_t sent = 0;                ///< of the answer
    std::optional<std::uint64_t> place;  ///< in the stream, if the stream follows the answer
    bool closes = false;                 ///< broken, or done
  };

  PageServerOrder order;
  Descriptor listener = Descriptor::borrowed(-1);
  std::uint16_t port = 0;
  std::vector<Client> clients;
  std::string kept;         ///< of the stream
  std::uint64_t first = 0;  ///< the place of the first kept byte in the stream
  bool ended = false;

  std::string host() const { return fmt::format("{}:{}", order.host, port); }
  std::string folder() const { return fmt::format("http://{}/{}/", host(), order.token); }
  std::string head(std::string_view status, std::string_view type) const;
  std::string served_page() const;
  void answer(Client& client) const;
  void accept_all();
  void hear(Client& client) const;
  void send_to(Client& client) const;
  bool waits_to_send(const Client& client) const {
    return client.sent < client.answer.size() || (client.place && *client.place < first + kept.size());
  }
};

std::string PageServer::State::head(std::string_view status, std::string_view type) const {
  return fmt::format(
      "HTTP/1.1 {}\r\nContent-Type: {}\r\nConnection: close\r\nCache-Control: no-store\r\n"
      "X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\n"
      "Content-Security-Policy: connect-src {}; frame-ancestors 'none'\r\n\r\n",
      status, type, folder());
}

/// The page, which may connect to this server only, and finds a mark that there is a robot.
std::string PageServer::State::served_page() const {
  std::string page = order.page;
  page.replace(page.find(page_policy), page_policy.size(), "connect-src " + folder());
  page.insert(page.find(page_head) + page_head.size(), "<meta name=\"labmouse-robot\" content=\"lines\" />");
  return page;
}

/// Decides on a whole request.
void PageServer::State::answer(Client& client) const {
  const std::string_view request = client.request;
  const auto refuse = [&](std::string_view status) {
    client.answer = head(status, "text/plain") + std::string(status) + "\n";
  };
  const std::string_view line = request.substr(0, request.find("\r\n"));
  constexpr std::string_view method = "GET /", protocol = " HTTP/1.1";
  if (!line.starts_with(method) || !line.ends_with(protocol)) return refuse("400 Bad Request");
  if (header_of(request, "host") != host()) return refuse("403 Forbidden");
  const std::string_view path = line.substr(method.size(), line.size() - method.size() - protocol.size());
  const auto slash = path.find('/');
  if (slash == std::string_view::npos || !same_secret(path.substr(0, slash), order.token))
    return refuse("404 Not Found");
  const std::string_view name = path.substr(slash + 1);
  if (name.empty()) {
    client.answer = head("200 OK", "text/html; charset=utf-8") + served_page();
  } else if (name == "begin") {
    client.answer = head("200 OK", "application/json") + order.begin;
  } else if (name == "lines") {
    client.answer = head("200 OK", "application/octet-stream");
    client.place = first;
  } else {
    refuse("404 Not Found");
  }
}

void PageServer::State::accept_all() {
  while (true) {
    Descriptor opened = Descriptor::opened(accept(listener.number(), nullptr, nullptr));
    if (opened.number() < 0) return;
    if (clients.size() >= most_clients || !set_unwaiting(opened.number())) continue;
#ifdef SO_NOSIGPIPE
    const int on = 1;
    setsockopt(opened.number(), SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof on);
#endif
    clients.push_back({.descriptor = std::move(opened),
                       .end = ServerClock::now() + std::chrono::milliseconds(order.patience),
                       .request = {},
                       .answer = {},
                       .place = {}});
  }
}

/// Reads of a request what is there. What follows a request is dropped.
void PageServer::State::hear(Client& client) const {
  std::array<char, 4096> bytes{};
  const std::ptrdiff_t count = recv(client.descriptor.number(), bytes.data(), bytes.size(), 0);
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
  if (count <= 0) return void(client.closes = true);
  if (!client.answer.empty()) return;
  client.request.append(bytes.data(), static_cast<std::size_t>(count));
  const auto end = client.request.find("\r\n\r\n");
  if (end <= most_request) return answer(client);  // npos is larger
  if (client.request.size() > most_request) client.answer = head("431 Request Header Fields Too Large", "text/plain");
}

/// Sends of the answer, and then of the stream, what the connection takes.
void PageServer::State::send_to(Client& client) const {
  while (!client.closes && waits_to_send(client)) {
    std::string_view left = std::string_view(client.answer).substr(client.sent);
    if (left.empty() && *client.place < first) return void(client.closes = true);
    if (left.empty()) left = std::string_view(kept).substr(static_cast<std::size_t>(*client.place - first));
    const std::ptrdiff_t count = send(client.descriptor.number(), left.data(), left.size(), without_signal);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (count <= 0) return void(client.closes = true);
    if (client.sent < client.answer.size())
      client.sent += static_cast<std::size_t>(count);
    else
      *client.place += static_cast<std::uint64_t>(count);
  }
  if (!client.answer.empty() && !waits_to_send(client) && (!client.place || ended)) client.closes = true;
}

void PageServer::serve(int milliseconds) {
  State& state = *state_;
  for (int wait = milliseconds;; wait = 0) {
    std::vector<pollfd> waiting{{state.listener.number(), POLLIN, 0}};
    for (const State::Client& client : state.clients)
      waiting.push_back(
          {client.descriptor.number(), static_cast<short>(state.waits_to_send(client) ? POLLIN | POLLOUT : POLLIN), 0});
    const bool ready = poll(waiting.data(), static_cast<nfds_t>(waiting.size()), wait) > 0;
    const auto now = ServerClock::now();
    for (std::size_t i = 0; i < state.clients.size(); ++i) {
      State::Client& client = state.clients[i];
      if (ready && waiting[i + 1].revents != 0) state.hear(client);
      state.send_to(client);
      const bool streams = client.place && client.sent == client.answer.size();
      if (!streams && now >= client.end) client.closes = true;
    }
    if (ready && waiting[0].revents != 0) state.accept_all();
    std::erase_if(state.clients, [](const State::Client& client) { return client.closes; });
    if (!ready) return;
  }
}

void PageServer::add(std::string_view bytes) {
  State& state = *state_;
  state.kept += bytes;
  // Half of it goes at once, so that not every line moves all bytes.
  if (state.kept.size() > most_kept) {
    const auto line = state.kept.find('\n', state.kept.size() - most_kept / 2);
    const std::size_t gone = line == std::string::npos ? state.kept.size() - most_kept / 2 : line + 1;
    state.kept.erase(0, gone);
    state.first += gone;
  }
  for (State::Client& client : state.clients)
    if (client.place) state.send_to(client);
}

void PageServer::end() { state_->ended = true; }
std::uint16_t PageServer::port() const { return state_->port; }
std::string PageServer::link() const { return state_->folder() + "#live"; }

OpenedServer open_page_server(PageServerOrder order) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  if (inet_pton(AF_INET, order.host.c_str(), &address.sin_addr) != 1 || address.sin_addr.s_addr == INADDR_ANY)
    return {nullptr, "is not an IPv4 address of this computer, such as 192.168.4.2"};
  auto state = std::make_unique<PageServer::State>();
  state->listener = Descriptor::opened(socket(AF_INET, SOCK_STREAM, 0));
  socklen_t size = sizeof address;
  auto* plain = reinterpret_cast<sockaddr*>(&address);
  if (state->listener.number() < 0 || !set_unwaiting(state->listener.number()) ||
      bind(state->listener.number(), plain, size) != 0 || listen(state->listener.number(), 16) != 0 ||
      getsockname(state->listener.number(), plain, &size) != 0)
    return {nullptr, "cannot be served on: " + cause_of(errno)};
  state->port = ntohs(address.sin_port);
  state->order = std::move(order);
  return {std::unique_ptr<PageServer>(new PageServer(std::move(state))), {}};
}

#endif

PageServer::PageServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PageServer::~PageServer() = default;

}  // namespace labmouse
