using System.Runtime.InteropServices;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>What the surfaces of a pair are, where that is not what their colliders' coefficients say.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct PairSurface
{
    public float Friction;
    public float Restitution;

    /// <summary>How fast the surfaces run past their bodies, both together, along t = (ny, -nx) as A sees it.</summary>
    public float Speed;

    /// <summary>
    /// Arm at which a normal impulse may resist that one rolls on the other, a length; of <see cref="IPairSurfaces"/> a share of the
    /// smaller piece's half width.
    /// </summary>
    public float RollingArm;

    /// <summary>Places of the pieces in their colliders.</summary>
    public int SegmentA;
    public int SegmentB;

    /// <summary>1: friction and restitution are these, and not what the colliders say.</summary>
    public int IsSet;

    /// <summary>
    /// Forces of friction at both points and torque against rolling in the last substep; what they are is told by the names of the points.
    /// </summary>
    public float Rub0;
    public float Rub1;
    public float Roll;
    public uint Id0;
    public uint Id1;

    /// <summary>Friction and rolling are found by a pass of their own: see <c>SurfacePass</c>.</summary>
    public readonly bool IsSpecial => IsSet != 0 && (Speed != 0 || RollingArm > 0);
}

/// <summary>
/// Says what the surfaces of a pair are. It is asked on the calling thread, for each pair of a collider that has
/// <see cref="ColliderFlags.OwnSurface"/>.
/// </summary>
internal interface IPairSurfaces
{
    /// <summary>All pairs are asked about, whatever their colliders.</summary>
    bool JudgesAll { get; }

    /// <param name="colliderA">The one created first.</param>
    /// <param name="colliderB">The other.</param>
    /// <param name="surface">Has friction and restitution as the colliders say, and which pieces they are.</param>
    void Describe(int colliderA, int colliderB, ref PairSurface surface);
}

/// <summary>The surfaces of pairs, by contact. There are none unless somebody sets one.</summary>
internal sealed class PairSurfaces
{
    private readonly Column<PairSurface> _surfaces = new Column<PairSurface>();

    /// <summary>Some pair may have surfaces of its own.</summary>
    public bool IsOn { get; private set; }

    /// <summary>Some pair needs the pass.</summary>
    [NotState(Why.OfOneStep)]
    public bool AnySpecial { get; set; }

    public ref PairSurface this[int contact] => ref _surfaces[contact];

    /// <summary>From now on pairs have surfaces.</summary>
    public void TurnOn() => IsOn = true;

    public void EnsureCapacity(int contacts) => _surfaces.EnsureCapacity(contacts);

    public void Visit(StateStream s)
    {
        s.Column(_surfaces);
        IsOn = s.Value(IsOn);
    }
}
