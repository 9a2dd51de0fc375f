/** Does @param work again and again, @param period ms (or as it says) after it has ended; one at a time. Hidden pages wait a second. */
export function poll(work: () => Promise<void>, period: number): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let isOver = false;
  const turn = async (): Promise<void> => {
    await work();
    if (isOver) return;
    timer = setTimeout(() => void turn(), document.hidden ? Math.max(period, 1000) : period);
  };
  void turn();
  return () => {
    isOver = true;
    clearTimeout(timer);
  };
}
