using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>
/// All that the update of a contact reads of one of its pieces, in one cache line of 64 bytes, in the order of
/// <see cref="SideLanes"/>: a piece has several contacts, so what lies in seven tables is put together once a step.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 64)]
internal struct ContactSide
{
    public float X;
    public float Y;
    public float Cos;
    public float Sin;

    public float HalfX;
    public float HalfY;
    public float Extent;
    public float Reach;

    public float VelocityX;
    public float VelocityY;
    public float AngularVelocity;
    public SideFlags Flags;

    public float InverseMass;
    public float InverseInertia;
    public float Friction;
    public float Restitution;
}

/// <summary>
/// The sides of all pieces, rewritten at the start of each narrow phase. They are forgotten at its end, but for worlds where some of them may be left as they
/// were, or compared with what they were.
/// </summary>
internal sealed unsafe class ContactSides
{
    /// <summary>The piece of an empty lane: its side is inert.</summary>
    public const int NoPiece = -1;

    private readonly Column<ContactSide> _sides = new Column<ContactSide>();
    private readonly Column<int> _hulls = new Column<int>();
    private BodySteps? _steps;
    private ContactSide* _first;
    private bool _isKept;

    /// <summary>A listener hears, or has heard, of a piece.</summary>
    public bool AnyHeard { get; private set; }

    /// <summary>The side of piece 0; that of <see cref="NoPiece"/> stands before it.</summary>
    public ContactSide* Pointer => _first + 1;

    /// <summary>Where the corners of each piece are, as <see cref="HullLanes.Pack"/> gives it: all that the kernels of hulls need besides. Something stands at <see cref="NoPiece"/>.</summary>
    public int* Hulls => _hulls.Pointer + 1;

    /// <summary>Makes room for the sides of all pieces.</summary>
    /// <param name="shapes">The pieces.</param>
    /// <param name="steps">Where a change of a side is noted; null if nobody asks.</param>
    /// <param name="maySleep">Bodies may fall asleep.</param>
    /// <param name="scratch">Where they are if they are not kept.</param>
    public void Begin(ShapeStore shapes, BodySteps? steps, bool maySleep, Scratch scratch)
    {
        _steps = steps;
        _isKept |= steps != null || maySleep;
        if (_isKept)
        {
            Keep(shapes);
        }
        else
        {
            _first = scratch.Take<ContactSide>(shapes.PieceIds.End + 1);
        }

        _hulls.EnsureCapacity(shapes.PieceIds.End + 1);
        _first[0] = new ContactSide { Cos = 1, HalfX = 1, HalfY = 1, Flags = SideFlags.Box };
    }

    /// <summary>Makes room ahead for sides that are kept from step to step.</summary>
    public void Reserve(ShapeStore shapes)
    {
        if (!_isKept)
        {
            _sides.EnsureCapacity(shapes.PieceIds.End + 1);
        }
    }

    /// <summary>Writes the sides of a piece that falls asleep: from now on they stay as they are.</summary>
    public void LayDown(ShapeStore shapes, BodyStore bodies, ProxyInfo* proxies, byte* moves, int piece)
    {
        _isKept = true;
        Keep(shapes);
        Prepare(shapes, bodies, proxies, moves, piece, piece + 1);
    }

    /// <summary>Writes the sides of pieces in a row, but for those asleep, which have not changed. The first begins a word of bits.</summary>
    public void Write(ShapeStore shapes, BodyStore bodies, ProxyInfo* proxies, byte* moves, int first, int end)
    {
        ulong* visited = shapes.VisitedPieces.Words;
        while (first < end)
        {
            int last = first;
            while (last < end && visited[last / BitSet.WordBits] != 0)
            {
                last = Math.Min((last | (BitSet.WordBits - 1)) + 1, end);
            }

            Prepare(shapes, bodies, proxies, moves, first, last);
            first = (last | (BitSet.WordBits - 1)) + 1;
        }
    }

    /// <summary>Writes the sides of pieces in a row.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public void Prepare(ShapeStore shapes, BodyStore bodies, ProxyInfo* proxies, byte* moves, int first, int end)
    {
        ContactSide* sides = Pointer;
        int* hulls = Hulls;
        Piece* pieces = shapes.Pieces.Pointer;
        ColliderInfo* colliders = shapes.Colliders.Pointer;
        BodyPose* poses = bodies.Pose.Pointer;
        BodyState* states = bodies.State.Pointer;
        BodyMass* masses = bodies.Mass.Pointer;
        BodyFlags* flags = bodies.Flags.Pointer;
        SideFlags heard = SideFlags.None;
        BodyStep* steps = _steps == null ? null : _steps.Pointer;
        for (int i = first; i < end; i++)
        {
            Piece* piece = pieces + i;
            if (piece->VertexCount == 0)
            {
                continue;
            }

            int body = piece->Body;
            ContactSide* side = sides + i;
            BodyPose* pose = poses + body;
            float cos = pose->Cos;
            float sin = pose->Sin;
            Vector2 axis = piece->Kind == ShapeKind.Box ? piece->Axis : Vector2.UnitX;
            side->X = (cos * piece->Center.X) - (sin * piece->Center.Y);
            side->Y = (sin * piece->Center.X) + (cos * piece->Center.Y);
            side->Cos = (cos * axis.X) - (sin * axis.Y);
            side->Sin = (sin * axis.X) + (cos * axis.Y);
            side->HalfY = piece->Half.Y;
            side->Extent = piece->Extent;
            side->Reach = piece->Reach;
            BodyState* state = states + body;
            side->VelocityX = state->LinearVelocity.X;
            side->VelocityY = state->LinearVelocity.Y;
            side->AngularVelocity = state->AngularVelocity;
            ColliderInfo* collider = colliders + piece->Collider;

            // What sleeps can be moved: a contact with it wakes it before it is solved.
            bool moving = moves[body] != 0 || (flags[body] & BodyFlags.Asleep) != 0;
            SideFlags now = (proxies[i].Flags & ProxyFlags.Moved) != 0 ? SideFlags.NewBox : SideFlags.None;
            SideFlags before = side->Flags;
            side->Flags = now | Describe(piece, collider->Flags, flags[body], moving);
            if (steps != null)
            {
                Note(steps + body, before, side->Flags);
            }

            side->HalfX = (side->Flags & SideFlags.Box) != 0 ? piece->Half.X : piece->Radius;
            heard |= side->Flags;
            hulls[i] = HullLanes.Pack(piece->VertexStart, piece->VertexCount);
            side->InverseMass = moving ? masses[body].InverseMass : 0;
            side->InverseInertia = moving ? masses[body].InverseInertia : 0;
            side->Friction = collider->Friction;
            side->Restitution = collider->Restitution;
        }

        // Workers only ever set it.
        if ((heard & SideFlags.Heard) != 0)
        {
            AnyHeard = true;
        }
    }

    private void Keep(ShapeStore shapes)
    {
        _sides.EnsureCapacity(shapes.PieceIds.End + 1);
        _first = _sides.Pointer;
    }

    private static void Note(BodyStep* step, SideFlags before, SideFlags now)
    {
        // Several workers may write the same: each flag is a byte of its own, which is only ever set here.
        if ((now & SideFlags.NewBox) != 0)
        {
            step->HasNewBox = 1;
        }

        if (((before ^ now) & ~SideFlags.NewBox) != 0)
        {
            step->IsAltered = 1;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static SideFlags Describe(Piece* piece, ColliderFlags collider, BodyFlags body, bool moving)
    {
        SideFlags flags = moving ? SideFlags.Exists | SideFlags.Moves : SideFlags.Exists;
        flags |= (collider & ColliderFlags.ResponseEnabled) != 0 ? SideFlags.Responds : SideFlags.None;
        flags |= (collider & (ColliderFlags.WantsContact | ColliderFlags.WantsSeparation)) != 0 ? SideFlags.Heard : SideFlags.None;
        flags |= moving && (body & BodyFlags.IgnoreGravity) == 0 ? SideFlags.Pulled : SideFlags.None;
        flags |= (body & BodyFlags.Static) == 0 ? SideFlags.Turns : SideFlags.None;
        flags |= (body & BodyFlags.Fast) != 0 ? SideFlags.Fast : SideFlags.None;
        if ((piece->Flags & PieceFlags.OneSided) != 0)
        {
            return flags;
        }

        if (piece->Flags == PieceFlags.None && piece->VertexCount > 1 && piece->VertexCount <= HullLanes.MostCorners)
        {
            flags |= SideFlags.Hull;
        }

        if (piece->Kind == ShapeKind.Box)
        {
            return flags | SideFlags.Box | (piece->Axis != Vector2.UnitX ? SideFlags.Tilted : SideFlags.None);
        }

        return piece->Kind == ShapeKind.Circle ? flags | SideFlags.Circle : flags;
    }
}
