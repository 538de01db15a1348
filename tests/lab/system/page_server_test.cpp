// The server of the page: who gets what, and who is refused.
#include "labmouse/lab/system/page_server.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <string>
#include <vector>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {
namespace {

const std::string html =
    "<html><head><meta content=\"connect-src ws://127.0.0.1:*; img-src blob:\" /></head><body>page</body></html>";

class APageServer : public testing::Test {
 protected:
  /// A client that has connected and sent that.
  Descriptor client(const std::string& sent) const {
    Descriptor made = Descriptor::opened(socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(server_->port());
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(made.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(send(made.number(), sent.data(), sent.size(), MSG_NOSIGNAL), static_cast<ssize_t>(sent.size()));
    return made;
  }
  std::string get(const std::string& path, const std::string& host) const {
    return "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n";
  }
  std::string host() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  std::string get(const std::string& path) const { return get(path, host()); }

  /// What is there for a client; sets `closed` at the end.
  static std::string taken(const Descriptor& client, bool& closed) {
    std::string all;
    std::array<char, 65536> bytes{};
    while (true) {
      const ssize_t count = recv(client.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (count <= 0) {
        closed = closed || count == 0 || (errno != EAGAIN && errno != EWOULDBLOCK);
        return all;
      }
      all.append(bytes.data(), static_cast<std::size_t>(count));
    }
  }
  /// All that a client gets until the server closes.
  std::string until_closed(const Descriptor& client) const {
    std::string all;
    bool closed = false;
    for (int i = 0; i < 20'000 && !closed; ++i) {
      server_->serve(1);
      all += taken(client, closed);
    }
    EXPECT_TRUE(closed);
    return all;
  }
  std::string answer(const std::string& sent) const { return until_closed(client(sent)); }
  /// Serves until a client has got text with that end.
  std::string until_text(const Descriptor& client, const std::string& end) const {
    std::string all;
    bool closed = false;
    for (int i = 0; i < 20'000 && !closed && !all.ends_with(end); ++i) {
      server_->serve(1);
      all += taken(client, closed);
    }
    EXPECT_TRUE(all.ends_with(end));
    return all;
  }
  static std::string status(const std::string& answer) { return answer.substr(0, answer.find("\r\n")); }

  std::unique_ptr<PageServer> server_ =
      open_page_server({.token = "secret", .page = html, .begin = R"({"width":2})", .patience = 60'000}).server;
};

TEST_F(APageServer, ServesThePageThatMayReadThisServerOnly) {
  const std::string folder = "http://" + host() + "/secret/";
  EXPECT_EQ(server_->link(), folder + "#live");
  const std::string page = answer(get("/secret/"));
  EXPECT_EQ(status(page), "HTTP/1.1 200 OK");
  EXPECT_NE(page.find("content=\"connect-src " + folder + "; img-src blob:\""), std::string::npos) << page;
  EXPECT_NE(page.find("Content-Security-Policy: connect-src " + folder), std::string::npos);
  EXPECT_NE(page.find("<head><meta name=\"labmouse-robot\""), std::string::npos);
  EXPECT_EQ(page.find("ws://"), std::string::npos);
  EXPECT_TRUE(answer(get("/secret/begin")).ends_with("\r\n\r\n{\"width\":2}"));
}

TEST_F(APageServer, SendsTheStreamToAllWhoRead) {
  server_->add("0 0 N 101\n");
  const Descriptor one = client(get("/secret/lines"));
  until_text(one, "\r\n\r\n0 0 N 101\n");
  server_->add(std::string("\0\xff\n", 3));
  until_text(one, std::string("\0\xff\n", 3));
  server_->end();
  EXPECT_EQ(until_closed(one), "");
  EXPECT_TRUE(answer(get("/secret/lines")).ends_with("0 0 N 101\n" + std::string("\0\xff\n", 3)));
}

TEST_F(APageServer, RefusesWhoDoesNotKnowTheTokenOrNamesAnotherHost) {
  for (const char* path : {"/", "/secre/", "/Secret/", "/secrets/", "//", "/secret", "/secret/other", "/secret/../"})
    EXPECT_EQ(status(answer(get(path))), "HTTP/1.1 404 Not Found") << path;
  for (const std::string& name : {std::string("evil.example"), "evil.example:" + std::to_string(server_->port()),
                                  std::string("127.0.0.1"), host() + "0", std::string()})
    EXPECT_EQ(status(answer(get("/secret/", name))), "HTTP/1.1 403 Forbidden") << name;
  EXPECT_EQ(status(answer("GET /secret/ HTTP/1.1\r\n\r\n")), "HTTP/1.1 403 Forbidden");
  for (const std::string& hosts : {host() + "\r\nHost: evil.example", "evil.example\r\nHost: " + host()})
    EXPECT_EQ(status(answer(get("/secret/", hosts))), "HTTP/1.1 403 Forbidden") << hosts;
  for (const char* line : {"POST /secret/ HTTP/1.1", "GET http://x/secret/ HTTP/1.1", "GET /secret/", "x"})
    EXPECT_EQ(status(answer(std::string(line) + "\r\nHost: " + host() + "\r\n\r\n")), "HTTP/1.1 400 Bad Request");
}

TEST_F(APageServer, RefusesGiantRequests) {
  EXPECT_EQ(status(answer(std::string(PageServer::most_request + 1, 'x'))),
            "HTTP/1.1 431 Request Header Fields Too Large");
}

TEST_F(APageServer, DisconnectsClientsThatTakeTooLong) {
  server_ = open_page_server({.token = "secret", .page = html, .begin = {}, .patience = 0}).server;
  EXPECT_EQ(answer("GET /secret/ HT"), "");
}

TEST_F(APageServer, HasALimitOfClients) {
  std::vector<Descriptor> many;
  for (std::size_t i = 0; i < PageServer::most_clients; ++i) many.push_back(client("GET"));
  server_->serve(1);
  EXPECT_EQ(answer(get("/secret/begin")), "");
  many.clear();
  server_->serve(1);
  EXPECT_EQ(status(answer(get("/secret/begin"))), "HTTP/1.1 200 OK");
}

TEST_F(APageServer, KeepsTheNewestLinesAndLeavesReadersBehindThatAreTooSlow) {
  const Descriptor slow = client(get("/secret/lines"));
  server_->serve(1);
  const std::string line = "3 5 E 01?0 batt=7900 state=search\n";
  std::size_t sent = 0;
  for (; sent < 5 * PageServer::most_kept; sent += line.size()) server_->add(line);
  server_->end();
  std::string got = until_closed(slow);
  got.erase(0, got.find("\r\n\r\n") + 4);
  EXPECT_LT(got.size(), sent);
  for (std::size_t i = 0; i < got.size(); ++i) ASSERT_EQ(got[i], line[i % line.size()]) << "a gap at " << i;
  const std::string late = answer(get("/secret/lines"));
  const std::string stream = late.substr(late.find("\r\n\r\n") + 4);
  EXPECT_LE(stream.size(), PageServer::most_kept);
  EXPECT_GE(stream.size(), PageServer::most_kept / 2 - line.size());
  EXPECT_TRUE(stream.starts_with(line));
}

TEST_F(APageServer, IsOnlyAtAnAddressOfThisComputer) {
  for (const char* wrong : {"0.0.0.0", "robot", "", "127.0.0.1:80", "192.0.2.1"}) {
    const OpenedServer opened = open_page_server({.host = wrong, .token = "t", .page = html, .begin = {}});
    EXPECT_FALSE(opened.server) << wrong;
    EXPECT_NE(opened.error, "") << wrong;
  }
  EXPECT_EQ(wrong_live_page(html), "");
  EXPECT_NE(wrong_live_page("<html><head></head></html>"), "");
  EXPECT_NE(wrong_live_page(html + html), "");
}

}  // namespace
}  // namespace labmouse
