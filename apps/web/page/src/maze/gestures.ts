// Wheel, drag and pinch on a canvas: nearer, farther, and aside.

export interface Looking {
  scale(): number;
  /** Nearer by that factor around a place of the canvas, in pixels of the page. */
  zoomBy(factor: number, x: number, y: number): void;
  /** Aside, in pixels of the page. */
  panBy(x: number, y: number): void;
}

export interface Gestures {
  /** Whether a pointer that is pressed pulls the maze along; where not, it is for somebody else. */
  mayDrag(event: PointerEvent): boolean;
  /** Two fingers are on the canvas: what one of them had begun alone does not count. */
  twoFingers?(): void;
}

const perPixel = 0.0016;
const lineHeight = 16;

function listenForWheel(canvas: HTMLCanvasElement, looking: Looking) {
  canvas.addEventListener(
    'wheel',
    (event) => {
      // What cannot come nearer or go farther scrolls the page, as anywhere else.
      const scrolls = looking.scale() === 1 && (event.deltaY > 0 || scrollY > 0);
      if (scrolls && !event.ctrlKey) return;
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? lineHeight : 1);
      // A pinch on a touchpad comes as a wheel with Ctrl, and in smaller numbers.
      const factor = Math.exp(-pixels * perPixel * (event.ctrlKey ? 6 : 1));
      looking.zoomBy(factor, event.offsetX, event.offsetY);
    },
    { passive: false },
  );
}

type Point = { x: number; y: number };
const middle = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
const apart = (a: Point, b: Point) => Math.hypot(a.x - b.x, a.y - b.y);

/** Listens before anybody else who listens to the canvas later, and keeps from them what is a gesture. */
export function listenForGestures(canvas: HTMLCanvasElement, looking: Looking, gestures: Gestures) {
  const fingers = new Map<number, Point>();
  let dragging = -1;
  let last: Point = { x: 0, y: 0 };
  listenForWheel(canvas, looking);

  const pointOf = ({ clientX: x, clientY: y }: PointerEvent): Point => ({ x, y });
  function pinch(id: number, to: Point) {
    const [other] = [...fingers].filter(([one]) => one !== id).map(([, point]) => point);
    const from = fingers.get(id)!;
    const [was, is] = [middle(from, other), middle(to, other)];
    const box = canvas.getBoundingClientRect();
    if (looking.scale() === 1 && apart(to, other) <= apart(from, other)) scrollBy(0, was.y - is.y);
    else looking.panBy(is.x - was.x, is.y - was.y);
    looking.zoomBy(apart(to, other) / Math.max(1, apart(from, other)), is.x - box.left, is.y - box.top);
  }
  canvas.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'touch') fingers.set(event.pointerId, pointOf(event));
    if (fingers.size === 2) {
      dragging = -1;
      gestures.twoFingers?.();
    }
    if (fingers.size > 1) return event.stopImmediatePropagation();
    if (!gestures.mayDrag(event)) return;
    event.stopImmediatePropagation();
    dragging = event.pointerId;
    last = pointOf(event);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    const at = pointOf(event);
    if (fingers.size === 2 && fingers.has(event.pointerId)) {
      pinch(event.pointerId, at);
      event.stopImmediatePropagation();
    } else if (event.pointerId === dragging) {
      looking.panBy(at.x - last.x, at.y - last.y);
      last = at;
    }
    if (fingers.has(event.pointerId)) fingers.set(event.pointerId, at);
  });
  const end = (event: PointerEvent) => {
    const pinched = fingers.size > 1;
    fingers.delete(event.pointerId);
    if (event.pointerId === dragging) dragging = -1;
    else if (!pinched) return;
    event.stopImmediatePropagation();
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
}
