// Work that takes long and that its user can stop, as a form shows it.
import type { CallName } from '../core/types';
import type { EarlyPage } from '../page/page';

/** `call` is that of the core which stopping ends; `draw` is called after each change. */
export function createRunning<Shown>(page: EarlyPage, call: CallName, draw: () => void) {
  const state = { isBusy: false, shown: null as Shown | null };
  let wanted = true;
  function set(changes: Partial<typeof state>) {
    Object.assign(state, changes);
    draw();
  }
  return {
    state,
    stop() {
      wanted = false;
      page.core.stop(call);
    },
    /** `work` reports what is to be shown, and asks between its pieces whether it is still wanted. */
    async run(work: (report: (shown: Shown) => void, wanted: () => boolean) => Promise<unknown>) {
      wanted = true;
      set({ isBusy: true, shown: null });
      try {
        await work(
          (shown) => set({ shown }),
          () => wanted,
        );
      } catch (error) {
        page.complain(error);
      } finally {
        set({ isBusy: false });
      }
    },
  };
}
