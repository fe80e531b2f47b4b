namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>All that is recorded of a run.</summary>
internal sealed class RunData
{
    /// <summary>Frames are packed together until there are so many, or so many numbers: what the page unpacks at a time.</summary>
    private const int MostFrames = 60;
    private const int MostNumbers = 4_000_000;

    private int _packed;

    public BodyTrack Bodies { get; } = new BodyTrack();

    public GeomTable Geoms { get; } = new GeomTable();

    public ContactTrack Contacts { get; } = new ContactTrack();

    public LinkTrack Links { get; } = new LinkTrack();

    public FluidTrack Fluids { get; } = new FluidTrack();

    public EventTrack Events { get; } = new EventTrack();

    public StepTrack Steps { get; } = new StepTrack();

    public int FrameCount { get; private set; }

    public double Time { get; private set; }

    public void Record(PhysicsSimulator simulator, RunRecorderOptions options, float dt)
    {
        Time += dt;
        int frame = FrameCount++;
        Bodies.Record(simulator.BodyList);
        Geoms.Record(simulator.GeomList, Bodies, frame);
        Links.Record(simulator.JointList, simulator.SpringList, Bodies);
        Fluids.Record(simulator.ControllerList);
        if (options.Contacts)
        {
            Contacts.Record(simulator.ArbiterList, Geoms);
        }

        if (options.Events)
        {
            Events.Record(simulator.Events, Geoms, Bodies, Links, frame);
        }

        Steps.Record(simulator, Time, dt, Bodies, Links);
        int numbers = (Bodies.Track.Slots * Bodies.Track.Columns.Length) + (Contacts.Track.Slots * Contacts.Track.Columns.Length);
        int frames = FrameCount - _packed;
        if (frames >= MostFrames || (long)frames * numbers >= MostNumbers)
        {
            Pack();
        }
    }

    /// <summary>Packs what is not packed yet.</summary>
    public void Pack()
    {
        if (FrameCount == _packed)
        {
            return;
        }

        Bodies.Track.Pack(_packed, keepSlots: true);
        Links.Track.Pack(_packed, keepSlots: true);
        Fluids.Track.Pack(_packed, keepSlots: true);
        Steps.Track.Pack(_packed, keepSlots: true);
        if (Contacts.Track.Frames > 0)
        {
            Contacts.Track.Pack(_packed, keepSlots: false);
            Contacts.Forget();
        }

        if (Events.Track.Frames > 0)
        {
            Events.Pack(_packed);
        }

        _packed = FrameCount;
    }
}
