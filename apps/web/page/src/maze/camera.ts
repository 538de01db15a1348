// Where one looks at a maze from: the whole of it, or closer, at some place of it.
import type { Geometry, Margins, MazeSize } from './geometry';

export interface Camera {
  /** 1 shows the whole maze. */
  scale: number;
  /** What is in the middle of the picture, in cells from the south-western post. */
  x: number;
  y: number;
}

export const wholeMaze = ({ width, height }: MazeSize): Camera => ({ scale: 1, x: width / 2, y: height / 2 });

/** Pixels of the page that a cell may always grow to. */
const largestCell = 96;
const leastMost = 4;

/** How close one may come: what `fitted` is the whole of is large enough then for the smallest signs. */
export const closest = (fitted: Geometry) => Math.max(leastMost, (largestCell * fitted.ratio) / fitted.pitch);

/** Nearer or farther by that factor, with the place (in cells) that is under the pointer staying there. */
export function zoomed(camera: Camera, factor: number, most: number, [x, y]: [number, number]): Camera {
  const scale = Math.min(Math.max(camera.scale * factor, 1), most);
  const stays = camera.scale / scale;
  return { scale, x: x + (camera.x - x) * stays, y: y + (camera.y - y) * stays };
}

/** Where the first cell begins, so that no room is left empty beside the maze that the maze could fill. */
function begin(wanted: number, size: number, room: number, before: number, after: number): number {
  const least = room - after - size;
  if (least >= before) return Math.round((before + least) / 2);
  return Math.round(Math.min(Math.max(wanted, least), before));
}

/** The geometry of a closer look, over all of a room of so many device pixels. */
export function seenThrough(camera: Camera, fitted: Geometry, room: MazeSize, margins: Margins): Geometry {
  const { width, height, ratio } = fitted;
  const pitch = Math.max(1, Math.round(fitted.pitch * camera.scale));
  const wall = Math.max(1, Math.round(pitch / 9));
  const rim = Math.ceil(wall / 2);
  const left = Math.max(rim, Math.round(margins.left * ratio));
  const bottom = Math.max(rim, Math.round(margins.bottom * ratio));
  return {
    ...fitted,
    pitch,
    wall,
    left: begin(room.width / 2 - camera.x * pitch, width * pitch, room.width, left, rim),
    top: begin(room.height / 2 - (height - camera.y) * pitch, height * pitch, room.height, rim, bottom),
    canvasWidth: room.width,
    canvasHeight: room.height,
  };
}

/** The camera that a geometry shows: what was wanted may have lain beyond the border. */
export const cameraOf = (scale: number, g: Geometry): Camera => ({
  scale,
  x: (g.canvasWidth / 2 - g.left) / g.pitch,
  y: g.height - (g.canvasHeight / 2 - g.top) / g.pitch,
});
