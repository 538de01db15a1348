// A button with a sign on it; its words are for who cannot see it, and for who asks.
import { Icon, type IconName } from './icons';

interface SignProps {
  icon: IconName;
  label: string;
  keys: string;
  class?: string;
  pressed?: boolean;
  hidden?: boolean;
  disabled?: boolean;
  act: () => void;
}

export const Sign = ({ icon, label, keys, pressed, act, ...rest }: SignProps) => (
  <button type="button" aria-label={label} title={`${label} (${keys})`} aria-pressed={pressed} onClick={act} {...rest}>
    <Icon name={icon} />
  </button>
);
