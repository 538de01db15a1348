// The colours of mms by their letters, in the order of mmsLetters, with a colour for text on them.
interface MmsColour {
  name: string;
  fill: string;
  text: string;
}

const light = '#ffffff';
const dark = '#000000';

export const mmsColours: MmsColour[] = [
  { name: 'black', fill: '#000000', text: light },
  { name: 'blue', fill: '#0000ff', text: light },
  { name: 'grey', fill: '#a9a9a9', text: dark },
  { name: 'cyan', fill: '#00ffff', text: dark },
  { name: 'green', fill: '#00ff00', text: dark },
  { name: 'orange', fill: '#ffa500', text: dark },
  { name: 'red', fill: '#ff0000', text: dark },
  { name: 'white', fill: '#ffffff', text: dark },
  { name: 'yellow', fill: '#ffff00', text: dark },
  { name: 'dark blue', fill: '#00008b', text: light },
  { name: 'dark cyan', fill: '#008b8b', text: light },
  { name: 'dark grey', fill: '#555555', text: light },
  { name: 'dark green', fill: '#006400', text: light },
  { name: 'dark orange', fill: '#b25900', text: light },
  { name: 'dark red', fill: '#8b0000', text: light },
  { name: 'dark violet', fill: '#5f0087', text: light },
  { name: 'dark yellow', fill: '#8b8b00', text: dark },
];
