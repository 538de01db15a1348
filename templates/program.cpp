// A mouse for labmouse: flood fill cell by cell to a goal, then a speed run on the shortest seen route.
#include <iostream>
#include <string>
#include <vector>
int main() {
  const int ways[] = {100, 1, -100, -1};  // to the north, east...; cell (x, y) is 101 + x + 100 y
  std::vector<int> walls(14000), cells(7000, 1), goals;  // walls: index = sum of both cells; 1 open, -1 closed
  int x = 0, y = 0, start = 0, cell = 0, heading = 0, stride = 1, racing = 0, steps = 0;
  for (std::string word, north; std::cin >> word; std::cin.ignore(9999, '\n')) {
    if (word == "size" && std::cin >> x >> y) for (int i = x * y; i--;) cells[101 + i % x + i / x * 100] = 0;
    if (word == "start" && std::cin >> x >> y >> north) start = 101 + x + 100 * y;
    if (word == "goal" && std::cin >> x >> y) goals.push_back(101 + x + 100 * y), cells[goals.back()] = 1;
    if (word == "stride") std::cin >> stride;
    if (word == "begin") std::cout << "labmouse 1" << std::endl;
    if (word != "sense") continue;
    if (steps++ == 0) cell = start, heading = std::string("nesw").find(north[0]);
    for (int to = heading + 3, free = 0; to < heading + 6 && std::cin >> free; ++to)  // left, ahead, right
      for (int n = 0; n <= free; ++n) walls[2 * cell + (2 * n + 1) * ways[to % 4]] = n < free ? 1 : -1;
    std::vector<int> moves = cells, queue = goals;  // first move of each cell to a goal: 4 n + direction
    for (int i = 0, most = racing ? stride : 1; i < 4 * int(queue.size()); ++i)  // four from each cell
      for (int n = 1, end = queue[i / 4], way = ways[i % 4]; n <= most && walls[2 * end + way] >= racing; ++n)
        if (moves[end += way] == 0) moves[end] = 4 * n + (i + 2) % 4, queue.push_back(end);
    int n = moves[cell] / 4, turn = (moves[cell] - heading + 5) % 4 - 1;  // -1 left, 0 ahead, 1 right, 2 back
    if (n == 0 && steps > 1) { racing = 1, steps = 0, std::cout << "reset" << std::endl; continue; }
    if (turn == 2) turn = walls[2 * cell - ways[heading]] == 0, n = turn == 1 ? 0 : -n;  // look, or reverse
    cell += n * ways[heading = (heading + turn + 4) % 4];
    std::cout << "move " << 90 * turn << ' ' << n << std::endl;
  }
}
