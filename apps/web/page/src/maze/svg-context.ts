// The part of a canvas' context that the painters use, writing SVG. (Libraries for this set inline styles, which the
// page's policy forbids.)
import type { Context } from './painter';

const escaped = (text: string) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
const brief = (number: number) => String(Math.round(number * 100) / 100);

const anchors: Record<string, string> = { center: 'middle', right: 'end', end: 'end' };
const baselines: Record<string, string> = { middle: 'central', top: 'text-before-edge', bottom: 'text-after-edge' };

export class SvgContext {
  fillStyle = '#000';
  strokeStyle = '#000';
  lineWidth = 1;
  lineCap = 'butt';
  lineJoin = 'miter';
  globalAlpha = 1;
  font = '400 10px sans-serif';
  textAlign = 'left';
  textBaseline = 'alphabetic';
  private path = '';
  private dash = '';
  private transform = '';
  private readonly parts: string[] = [];
  /** Rectangles of one colour become one path, or a maze would be thousands of elements. */
  private rectangles = '';
  private rectanglesLook = '';

  /** For the painters. */
  asContext(): Context {
    return this as unknown as Context;
  }

  /** What was painted, as elements. */
  elements(): string {
    this.endRectangles();
    return this.parts.join('\n');
  }

  setLineDash(dash: number[]) {
    this.dash = dash.map(brief).join(' ');
  }
  setTransform(...matrix: number[]) {
    const none = matrix.every((value, i) => value === [1, 0, 0, 1, 0, 0][i]);
    this.transform = none ? '' : ` transform="matrix(${matrix.map((value) => value.toFixed(4)).join(' ')})"`;
  }
  beginPath() {
    this.path = '';
  }
  moveTo(x: number, y: number) {
    this.path += `M${brief(x)} ${brief(y)}`;
  }
  lineTo(x: number, y: number) {
    this.path += `${this.path ? 'L' : 'M'}${brief(x)} ${brief(y)}`;
  }
  closePath() {
    this.path += 'Z';
  }
  /** Whole circles only, which is all that the painters draw. */
  arc(x: number, y: number, radius: number) {
    const r = brief(radius);
    this.path += `M${brief(x - radius)} ${brief(y)}a${r} ${r} 0 1 0 ${brief(2 * radius)} 0a${r} ${r} 0 1 0 ${brief(-2 * radius)} 0`;
  }
  fill() {
    this.add(`<path d="${this.path}"${this.filled()}/>`);
  }
  stroke() {
    this.add(`<path d="${this.path}"${this.stroked()}/>`);
  }
  fillRect(x: number, y: number, width: number, height: number) {
    const look = this.filled();
    if (look !== this.rectanglesLook || this.globalAlpha < 1) this.endRectangles();
    this.rectanglesLook = look;
    this.rectangles += `M${brief(x)} ${brief(y)}h${brief(width)}v${brief(height)}h${brief(-width)}z`;
  }
  strokeRect(x: number, y: number, width: number, height: number) {
    this.add(
      `<rect x="${brief(x)}" y="${brief(y)}" width="${brief(width)}" height="${brief(height)}"${this.stroked()}/>`,
    );
  }
  fillText(text: string, x: number, y: number) {
    this.write(text, x, y, this.filled());
  }
  strokeText(text: string, x: number, y: number) {
    this.write(text, x, y, this.stroked());
  }

  private write(text: string, x: number, y: number, look: string) {
    const [, weight, size, family] = /^(\d+) ([\d.]+)px (.*)$/.exec(this.font) ?? ['', '400', '10', 'sans-serif'];
    const anchor = anchors[this.textAlign] ? ` text-anchor="${anchors[this.textAlign]}"` : '';
    const baseline = baselines[this.textBaseline] ? ` dominant-baseline="${baselines[this.textBaseline]}"` : '';
    this.add(
      `<text x="${brief(x)}" y="${brief(y)}" font-family="${escaped(family)}" font-size="${size}" font-weight="${weight}"${anchor}${baseline}${look}>${escaped(text)}</text>`,
    );
  }
  private filled(): string {
    return ` fill="${escaped(String(this.fillStyle))}"${this.opacity()}${this.transform}`;
  }
  private stroked(): string {
    const dash = this.dash ? ` stroke-dasharray="${this.dash}"` : '';
    const ends = ` stroke-linecap="${this.lineCap}" stroke-linejoin="${this.lineJoin}"`;
    const line = ` stroke="${escaped(String(this.strokeStyle))}" stroke-width="${brief(this.lineWidth)}"`;
    return ` fill="none"${line}${ends}${dash}${this.opacity()}${this.transform}`;
  }
  private opacity(): string {
    return this.globalAlpha < 1 ? ` opacity="${brief(this.globalAlpha)}"` : '';
  }
  private add(element: string) {
    this.endRectangles();
    this.parts.push(element);
  }
  private endRectangles() {
    if (this.rectangles) this.parts.push(`<path d="${this.rectangles}"${this.rectanglesLook}/>`);
    this.rectangles = '';
  }
}
