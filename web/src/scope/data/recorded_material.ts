import { Decoder } from "../../canopen/decode";
import type { Eds } from "../../canopen/eds";
import { ServiceMap } from "../../canopen/services";
import { FrameStore } from "../../model/frame_store";
import { SampleStore } from "../../model/sample_store";
import { profileOf, type Profile } from "../../model/profile";
import { timelineOf, type Timeline } from "../../model/timeline";
import type { Recording } from "../../recording/recording";
import type { Pdo, UnitEvent } from "../../source/types";
import { extentOf, type Mark, type Material } from "./material";

/** What is known of the unit that was recorded. */
export interface Knowledge {
  nodeId?: number | undefined;
  eds?: Eds | undefined;
  pdos?: readonly Pdo[] | undefined;
  profile?: Profile | undefined;
}

/** A file that was opened, a recording of the session, or a result of the unit's trace. */
export class RecordedMaterial implements Material {
  readonly isLive = false;
  readonly version = 0;
  readonly name: string;
  readonly unit: string;
  readonly frames;
  readonly samples;
  readonly marks: readonly Mark[];
  readonly startedAt: number | undefined;
  readonly lost: number;
  readonly remark: string;
  readonly decoder: Decoder;
  private readonly states: Timeline;

  constructor(
    private readonly recording: Recording,
    knowledge: Knowledge = {},
    steps: readonly Mark[] = [],
  ) {
    this.name = recording.name;
    this.unit = recording.unit;
    this.frames = recording.frames;
    this.samples = recording.samples;
    this.startedAt = recording.startedAt;
    this.lost = recording.lost;
    this.remark = recording.remark;
    const trigger = recording.triggerT === undefined ? [] : [{ t: recording.triggerT, text: "trigger" }];
    this.marks = [...trigger, ...steps];
    const nodeId = recording.head?.node_id ?? knowledge.nodeId;
    const services = new ServiceMap({ nodeId, pdos: knowledge.pdos, eds: knowledge.eds });
    this.frames.relane(services.laneOf);
    const { eds, pdos } = knowledge;
    const profile = knowledge.profile ?? profileOf(recording.head);
    this.decoder = new Decoder({ services, eds, pdos, profile, events: () => recording.events });
    this.states = timelineOf(recording.events);
  }

  events(): readonly UnitEvent[] {
    return this.recording.events;
  }

  timeline(): Timeline {
    return this.states;
  }

  extent(): { from: number; to: number } {
    const { from, to, frames, samples, events } = this.recording;
    if (to > from) return { from, to };
    return extentOf([frames.from, frames.to, samples.from, samples.to, events[0]?.t, events.at(-1)?.t]);
  }
}

/** Nothing, until something is opened. */
export function emptyMaterial(): RecordedMaterial {
  const services = new ServiceMap();
  return new RecordedMaterial({
    name: "",
    format: "axrec",
    unit: "",
    from: 0,
    to: 0,
    frames: new FrameStore(services.laneOf, 16),
    samples: new SampleStore([], 16),
    events: [],
    lost: 0,
    remark: "",
  });
}
