#include "labmouse/lab/system/live_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/system/streams.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace labmouse {

#ifdef _WIN32

LiveSource::Piece LiveSource::read(int) { return {.bytes = {}, .ended = true, .error = {}}; }
void LiveSource::send(std::string_view) {}
OpenedSource open_source(const std::string&, int, LiveUse) { return {std::nullopt, "cannot be read on this system"}; }

#else

namespace {

using Clock = std::chrono::steady_clock;

OpenedSource failure(std::string error) { return {std::nullopt, std::move(error)}; }

constexpr const char* not_answered = "cannot be answered; name a serial port or tcp:HOST:PORT";

OpenedSource success(Descriptor descriptor) { return {LiveSource(std::move(descriptor)), {}}; }

struct Speed {
  int baud;
  speed_t code;
};

constexpr auto speeds = std::to_array<Speed>({
    {1200, B1200},
    {2400, B2400},
    {4800, B4800},
    {9600, B9600},
    {19200, B19200},
    {38400, B38400},
    {57600, B57600},
    {115200, B115200},
    {230400, B230400},
#ifdef B1000000
    {460800, B460800},
    {500000, B500000},
    {576000, B576000},
    {921600, B921600},
    {1000000, B1000000},
    {1500000, B1500000},
    {2000000, B2000000},
#endif
});

/// Passes bytes on as they come, without echo and without waiting for the end of a line. Returns an error, or nothing.
std::string make_raw(int terminal, int baud) {
  const auto* speed = std::find_if(speeds.begin(), speeds.end(), [&](const Speed& each) { return each.baud == baud; });
  if (speed == speeds.end()) {
    std::vector<int> all;
    for (const Speed& each : speeds) all.push_back(each.baud);
    return fmt::format("{} baud is not supported; set --baud to one of {}", baud, fmt::join(all, ", "));
  }
  termios settings{};
  if (tcgetattr(terminal, &settings) != 0) return "cannot be set up: " + cause_of(errno);
  cfmakeraw(&settings);
  // No line of a modem, and not stopped where the port is a controlling terminal.
  settings.c_cflag |= CLOCAL | CREAD;
  if (cfsetispeed(&settings, speed->code) != 0 || cfsetospeed(&settings, speed->code) != 0 ||
      tcsetattr(terminal, TCSANOW, &settings) != 0)
    return "cannot be set up: " + cause_of(errno);
  return {};
}

/// Whether waiting calls on the descriptor return at once, or wait.
bool set_waiting(int descriptor, bool waiting) {
  const int flags = fcntl(descriptor, F_GETFL);
  return flags >= 0 && fcntl(descriptor, F_SETFL, waiting ? flags & ~O_NONBLOCK : flags | O_NONBLOCK) == 0;
}

OpenedSource open_path(const std::string& path, int baud, LiveUse use) {
  // A serial port may wait for a modem when it is opened, a named pipe for a program that writes.
  const bool answers = use == LiveUse::read_and_answer;
  Descriptor opened =
      Descriptor::opened(open(path.c_str(), (answers ? O_RDWR : O_RDONLY) | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (opened.number() < 0)
    return failure(errno == ENOENT ? "no such file or device" : "cannot be opened: " + cause_of(errno));
  if (isatty(opened.number()) != 0) {
    if (std::string error = make_raw(opened.number(), baud); !error.empty()) return failure(std::move(error));
  } else if (answers) {
    return failure(not_answered);
  }
  set_waiting(opened.number(), !answers);
  return success(std::move(opened));
}

/// Milliseconds from now on, at least 0.
int until(Clock::time_point end) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
  return static_cast<int>(std::max<decltype(left)>(left, 0));
}

/// Waits until the descriptor is ready. Returns an error number, or 0.
int wait_for(int descriptor, short events, Clock::time_point end) {
  pollfd waiting{descriptor, events, 0};
  while (true) {
    const int ready = poll(&waiting, 1, until(end));
    if (ready > 0) return 0;
    if (ready == 0) return ETIMEDOUT;
    if (errno != EINTR) return errno;
  }
}

/// Connects a socket, which does not wait. Returns an error number, or 0.
int connect_within(int descriptor, const addrinfo& address, Clock::time_point end) {
  if (connect(descriptor, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (const int error = wait_for(descriptor, POLLOUT, end); error != 0) return error;
  int error = 0;
  socklen_t size = sizeof error;
  return getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

struct AddressesEnd {
  void operator()(addrinfo* addresses) const { freeaddrinfo(addresses); }
};

OpenedSource open_connection(const std::string& place) {
  const auto colon = place.rfind(':');
  const auto port =
      colon == std::string::npos ? std::nullopt : parse_whole<std::uint16_t>(std::string_view(place).substr(colon + 1));
  if (!port || *port == 0 || colon == 0)
    return failure("is not a TCP address; write tcp:HOST:PORT, such as tcp:192.168.4.1:23");
  std::string host = place.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_socktype = SOCK_STREAM;
  if (const int error = getaddrinfo(host.c_str(), std::to_string(*port).c_str(), &wanted, &found); error != 0)
    return failure(fmt::format("the host cannot be found: {}", gai_strerror(error)));
  const std::unique_ptr<addrinfo, AddressesEnd> addresses(found);
  const auto end = Clock::now() + std::chrono::seconds(5);
  int error = EADDRNOTAVAIL;
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    Descriptor opened = Descriptor::opened(socket(address->ai_family, address->ai_socktype, address->ai_protocol));
    if (opened.number() < 0 || fcntl(opened.number(), F_SETFD, FD_CLOEXEC) != 0 ||
        !set_waiting(opened.number(), false)) {
      error = errno;
      continue;
    }
    error = connect_within(opened.number(), *address, end);
    if (error == 0) return success(std::move(opened));
  }
  return failure("cannot be reached: " + cause_of(error));
}

}  // namespace

LiveSource::Piece LiveSource::read(int milliseconds) {
  pollfd waiting{descriptor_.number(), static_cast<short>(waiting_.empty() ? POLLIN : POLLIN | POLLOUT), 0};
  const int ready = poll(&waiting, 1, milliseconds);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return {};
  if ((waiting.revents & POLLOUT) != 0) {
    const std::ptrdiff_t sent = write_some(descriptor_.number(), waiting_.data(), waiting_.size());
    if (sent > 0) waiting_.erase(0, static_cast<std::size_t>(sent));
    if ((waiting.revents & ~POLLOUT) == 0) return {};
  }
  std::array<char, 4096> bytes{};
  const std::ptrdiff_t count = ready < 0 ? -1 : read_some(descriptor_.number(), bytes.data(), bytes.size());
  if (count > 0) return {.bytes = {bytes.data(), static_cast<std::size_t>(count)}, .ended = false, .error = {}};
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return {};
  return {.bytes = {}, .ended = true, .error = count == 0 ? std::string() : "cannot be read: " + cause_of(errno)};
}

void LiveSource::send(std::string_view bytes) {
  constexpr std::size_t most = 4096;
  if (waiting_.size() + bytes.size() <= most) waiting_ += bytes;
}

OpenedSource open_source(const std::string& name, int baud, LiveUse use) {
  if (const auto descriptor = descriptor_to_read(name))
    return use == LiveUse::read ? success(Descriptor::borrowed(*descriptor)) : failure(not_answered);
  constexpr std::string_view connection = "tcp:";
  if (name.starts_with(connection)) return open_connection(name.substr(connection.size()));
  return open_path(name, baud, use);
}

#endif

}  // namespace labmouse
