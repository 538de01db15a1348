// Posts: the points where walls meet.
//
//      (x,y+1) o---o       Post (x,y) is the south-west corner of cell (x,y): a maze has posts from (0,0) to
//              | c |       (width,height), those of the border included.
//        (x,y) o---o
#pragma once

#include "labmouse/grid/wall.hpp"

namespace labmouse {

/// A post by its coordinates; it moves with neighbour() as a cell does.
using Post = Cell;

/// The place of the wall between a post and the next post in a heading.
constexpr Wall wall_from(Post post, Heading heading) {
  switch (heading) {
    case Heading::north:
      return wall_at(post, Heading::west);
    case Heading::east:
      return wall_at(post, Heading::south);
    case Heading::south:
      return wall_at(neighbour(post, Heading::south), Heading::west);
    case Heading::west:
      break;
  }
  return wall_at(neighbour(post, Heading::west), Heading::south);
}

/// Whether the post stands inside a maze of that size, not on its border.
constexpr bool is_inner(Post post, Size size) {
  return post.x > 0 && post.y > 0 && post.x < size.width && post.y < size.height;
}

}  // namespace labmouse
