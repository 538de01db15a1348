// Speed and battery of a real robot over its lines.
import { useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { usePainted } from '../ui/painted';
import { paperWidth, tone } from '../ui/tones';
import type { Point } from './stream-log';

const height = 190;

function optionsOf(width: number): uPlot.Options {
  const font = `12px ${getComputedStyle(document.documentElement).fontFamily}`;
  const axis = { font, labelFont: font, labelSize: 18, ticks: { stroke: tone('line'), width: 1 } };
  const grid = { stroke: tone('line'), width: 1 };
  const line = { spanGaps: true, points: { show: false } };
  return {
    width,
    height,
    legend: { show: false },
    cursor: { show: false },
    scales: { x: { time: false } },
    axes: [
      { ...axis, stroke: tone('muted'), grid, label: 'line', size: 30 },
      { ...axis, stroke: tone('to-goal'), grid, label: 'speed, mm/s', size: 50 },
      { ...axis, stroke: tone('route'), grid: { show: false }, scale: 'batt', side: 1, label: 'battery, mV', size: 54 },
    ],
    series: [
      {},
      { ...line, label: 'speed', stroke: tone('to-goal'), width: 2 },
      { ...line, label: 'battery', scale: 'batt', stroke: tone('route'), width: 1.5, dash: [4, 2] },
    ],
  };
}

export function RobotCurves({ points }: { points: Point[] }) {
  const room = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const last = points.at(-1)?.line;
  usePainted(room, () => {
    plot.current?.destroy();
    plot.current = null;
    const width = paperWidth() ?? room.current!.clientWidth;
    if (width === 0 || points.length < 2) return;
    const data: uPlot.AlignedData = [points.map((p) => p.line), points.map((p) => p.v), points.map((p) => p.batt)];
    plot.current = new uPlot(optionsOf(width), data, room.current!);
  }, [last, points.length]);
  return <div class="speeds" role="img" aria-label="Speed and battery over the lines" ref={room} />;
}
