// Work of which only the newest wish counts: while one is done, later ones replace each other.
export class Latest<Wish> {
  private running = false;
  private next: { wish: Wish } | undefined;

  constructor(private readonly work: (wish: Wish) => Promise<void>) {}

  async ask(wish: Wish): Promise<void> {
    this.next = { wish };
    if (this.running) return;
    this.running = true;
    try {
      while (this.next) {
        const { wish: now } = this.next;
        this.next = undefined;
        await this.work(now);
      }
    } finally {
      this.running = false;
    }
  }
}
