using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>Events that are read after an update, and what contacts gave. (Additions to the original.)</content>
public partial class PhysicsSimulator
{
    private readonly PoseMemory _poses = new PoseMemory();
    [NotState(Why.Fixed)]
    private StepEvents? _events;

    /// <summary>
    /// The kinds of events that updates record; what is not recorded costs nothing. Set it when you make the scene: setting it looks at all
    /// geoms and wakes what sleeps, and pairs that already touch count as beginning to touch. Default <see cref="StepEventKinds.None"/>.
    /// (An addition to the original.)
    /// </summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value has a bit that is no member of the enum.</exception>
    public StepEventKinds RecordedEvents
    {
        get => _relay.Recorder.Kinds;
        set
        {
            if ((value & ~StepEventKinds.All) != 0)
            {
                throw Require.Range(nameof(RecordedEvents), value, "must be made of members of the enum StepEventKinds");
            }

            _relay.Recorder.Kinds = value;
            World.Pushes.TellsPushes = (value & (StepEventKinds.Hits | StepEventKinds.Pushes)) != 0;
            for (int i = 0; i < _table.GeomEnd; i++)
            {
                _table.Geom(i)?.Link.PushFlags(_table.Geom(i)!);
            }

            for (int i = 0; i < _table.BodyEnd; i++)
            {
                if (_table.Body(i) is { } body)
                {
                    _relay.Recorder.Take(body);
                }
            }
        }
    }

    /// <summary>What the last update recorded: a view, valid until the next update. (An addition to the original.)</summary>
    public StepEvents Events => _events ??= new StepEvents(_relay.Recorder);

    /// <summary>
    /// The approach speed from which on a contact is one of <see cref="StepEvents.Hits"/>, length/s; at least 0. In any case no contact
    /// counts whose surfaces approach more slowly than the speed that gravity gives a body in four substeps: they are at rest. Default 0.
    /// (An addition to the original.)
    /// </summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float HitSpeed
    {
        get => World.Pushes.HitSpeed;
        set => World.Pushes.HitSpeed = Require.NotNegative(value, nameof(HitSpeed));
    }

    /// <summary>
    /// A callback that decides the surface of a pair, where <see cref="FrictionType"/> and <see cref="RestitutionType"/> are not enough. It
    /// is called in each update for each pair of geoms that are near each other, on the calling thread, in an order that the scene alone
    /// decides. Null, the default, costs nothing. (An addition to the original.)
    /// </summary>
    public MaterialMixer? MixMaterials
    {
        get => _surfaces.Mixer;
        set
        {
            _surfaces.Mixer = value;
            if (value is not null)
            {
                World.Surfaces.Use();
            }
        }
    }

    /// <summary>
    /// True keeps the poses from the beginning of the last update, so that <see cref="Body.GetPose(float)"/> can find poses between
    /// updates; <see cref="FixedStepDriver"/> sets it. Default false, which costs nothing. It changes no bit of the motion. (An addition to
    /// the original.)
    /// </summary>
    public bool KeepsPoses
    {
        get => _poses.IsOn;
        set
        {
            if (value != _poses.IsOn)
            {
                _poses.IsOn = value;
                _poses.Keep(World);
            }
        }
    }

    /// <summary>
    /// Looks over the scene for likely mistakes: geoms whose bodies were not added, overlaps, stacks without friction, filters that exclude
    /// each other, thin walls, joints without length. It changes nothing. It takes time and memory, so use it in tests and while debugging,
    /// not in each update. (An addition to the original.)
    /// </summary>
    /// <returns>A new list, by the numbers of the kinds; empty if nothing was found. docs/Games.md has the kinds.</returns>
    /// <exception cref="System.ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="System.InvalidOperationException">The call comes from a handler of an update.</exception>
    public System.Collections.Generic.List<InspectionFinding> Inspect()
    {
        ThrowIfDisposed();
        return _isUpdating
            ? throw new System.InvalidOperationException("Inspect must not be called from a handler of an update.")
            : new SceneInspector(this).Run();
    }

    internal PoseMemory Poses => _poses;

    /// <summary>
    /// True adds up the impulses of each contact over the whole update, so that <see cref="Contact.NormalImpulse"/> and
    /// <see cref="Contact.TangentImpulse"/> are exact: their sum over the contacts of a body is its change of momentum, less that of
    /// gravity, forces, drag and joints. False takes the last substep for all of them. Recording <see cref="StepEventKinds.Hits"/> or
    /// <see cref="StepEventKinds.Pushes"/> adds them up too. It changes no bit of the motion. Default false. (An addition to the original.)
    /// </summary>
    public bool SumImpulses
    {
        get => World.Pushes.SumsImpulses;
        set => World.Pushes.SumsImpulses = value;
    }
}
