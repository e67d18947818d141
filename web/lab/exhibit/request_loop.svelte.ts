// Requests to the machine of which only the latest counts: while one is worked on, later ones
// replace each other. Says whether the work takes long, and why the last one failed.
const longWork = 400; // milliseconds

export class RequestLoop<Request> {
  /** The work takes so long that the visitor should know. */
  busy = $state(false);
  /** '': the last request was answered, or is worked on. */
  problem = $state('');
  /** The request that was made last. */
  latest: Request | undefined;
  private running = false;
  private next: { request: Request } | undefined;

  constructor(private readonly work: (request: Request) => Promise<void>) {}

  isOld(request: Request): boolean {
    return request !== this.latest;
  }

  async ask(request: Request): Promise<void> {
    this.latest = request;
    this.next = { request };
    if (this.running) return;
    this.running = true;
    while (this.next) {
      const { request: now } = this.next;
      this.next = undefined;
      await this.workOn(now);
    }
    this.running = false;
  }

  private async workOn(request: Request): Promise<void> {
    const late = setTimeout(() => (this.busy = true), longWork);
    this.problem = '';
    try {
      await this.work(request);
    } catch (error) {
      this.problem = (error as Error).message;
    } finally {
      clearTimeout(late);
      this.busy = false;
    }
  }
}
