using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;

namespace Farseer.Engine.Contacts;

/// <summary>Impulses and feed-forward of one point, carried from step to step by feature id.</summary>
internal struct PointMemory
{
    public uint Id;
    public float Normal;
    public float Tangent;
    public float PreviousNormal;
    public float PreviousTangent;
    public float Feed;
}

/// <summary>Turns a manifold into a lane of a bundle: arms in the contact frame, responses, and the impulses of matching points.</summary>
internal static unsafe class ContactRowWriter
{
    /// <summary>Below this share of k11·k22 the determinant is noise and the points are solved row by row.</summary>
    private const float DeterminantShare = 1e-3f;

    public static void ReadMemory(ContactBundle* row, int lane, out PointMemory first, out PointMemory second)
    {
        Read(&row->Point0, lane, out first);
        Read(&row->Point1, lane, out second);
    }

    /// <summary>
    /// Writes the constraint. <paramref name="rest"/> is the depth at which the contact rests, <paramref name="impulseScale"/>
    /// the ratio of this step's substep to the last one's (stored impulses are those of one substep).
    /// </summary>
    public static void Write(
        ContactBundle* row, int lane, in Manifold manifold, Vector2 offset, in BodyMass massA, in BodyMass massB, float rest, float impulseScale)
    {
        ReadMemory(row, lane, out PointMemory old0, out PointMemory old1);
        Vector2 normal = manifold.Normal;
        row->NormalX[lane] = normal.X;
        row->NormalY[lane] = normal.Y;
        float mA = massA.InverseMass;
        float iA = massA.InverseInertia;
        float mB = massB.InverseMass;
        float iB = massB.InverseInertia;
        row->MassA[lane] = mA;
        row->InertiaA[lane] = iA;
        row->MassB[lane] = mB;
        row->InertiaB[lane] = iB;
        WritePoint(&row->Point0, lane, manifold.Point0, normal, offset, rest, Match(manifold.Point0.Id, old0, old1), impulseScale);
        bool two = manifold.Count == 2;
        if (two)
        {
            WritePoint(&row->Point1, lane, manifold.Point1, normal, offset, rest, Match(manifold.Point1.Id, old0, old1), impulseScale);
        }
        else
        {
            ClearPoint(&row->Point1, lane);
        }

        row->Single[lane] = two ? 0 : 1;
        float m = mA + mB;
        float atA0 = row->Point0.TangentArmA[lane];
        float atB0 = row->Point0.TangentArmB[lane];
        float k11 = m + (iA * atA0 * atA0) + (iB * atB0 * atB0);
        float k22 = k11;
        float k12 = 0;
        float inverse = 0;
        if (two)
        {
            float atA1 = row->Point1.TangentArmA[lane];
            float atB1 = row->Point1.TangentArmB[lane];
            k22 = m + (iA * atA1 * atA1) + (iB * atB1 * atB1);
            k12 = m + (iA * atA0 * atA1) + (iB * atB0 * atB1);
            float determinant = (k11 * k22) - (k12 * k12);
            inverse = determinant > DeterminantShare * k11 * k22 ? 1f / determinant : 0;
        }

        row->K11[lane] = k11;
        row->K22[lane] = k22;
        row->K12[lane] = k12;
        row->InverseK11[lane] = 1f / k11;
        row->InverseK22[lane] = 1f / k22;
        row->InverseDeterminant[lane] = inverse;
        row->TangentMass0[lane] = 1f / (m + (iA * Square(row->Point0.NormalArmA[lane])) + (iB * Square(row->Point0.NormalArmB[lane])));
        row->TangentMass1[lane] = two
            ? 1f / (m + (iA * Square(row->Point1.NormalArmA[lane])) + (iB * Square(row->Point1.NormalArmB[lane])))
            : 0;
    }

    /// <summary>Makes a lane inert: no contact, or one that gives no impulse in this step.</summary>
    public static void Mute(ContactBundle* row, int lane)
    {
        ClearPoint(&row->Point0, lane);
        ClearPoint(&row->Point1, lane);
    }

    /// <summary>An empty lane: bodies 0 (the dummy), no mass, unit responses so that nothing divides by zero.</summary>
    public static void ClearLane(ContactBundle* row, int lane)
    {
        row->BodyA[lane] = 0;
        row->BodyB[lane] = 0;
        row->Contact[lane] = -1;
        row->NormalX[lane] = 0;
        row->NormalY[lane] = 0;
        row->Friction[lane] = 0;
        row->MassA[lane] = 0;
        row->InertiaA[lane] = 0;
        row->MassB[lane] = 0;
        row->InertiaB[lane] = 0;
        row->K11[lane] = 1;
        row->K22[lane] = 1;
        row->K12[lane] = 0;
        row->InverseK11[lane] = 1;
        row->InverseK22[lane] = 1;
        row->InverseDeterminant[lane] = 1;
        row->TangentMass0[lane] = 0;
        row->TangentMass1[lane] = 0;
        row->FeedRate[lane] = 0;
        row->FeedShare[lane] = 0;
        row->Single[lane] = 0;
        row->Deep[lane] = 0;
        row->Restitution[lane] = 0;
        row->Island[lane] = 0;
        row->Level[lane] = 0;
        Mute(row, lane);
    }

    /// <summary>Moves a contact from one lane to another; every field is a column of four bytes a lane.</summary>
    public static void MoveLane(ContactBundle* source, int sourceLane, ContactBundle* target, int targetLane)
    {
        int* from = (int*)source + sourceLane;
        int* to = (int*)target + targetLane;
        int columns = sizeof(ContactBundle) / (sizeof(int) * ContactBundle.Lanes);
        for (int i = 0; i < columns; i++)
        {
            to[i * ContactBundle.Lanes] = from[i * ContactBundle.Lanes];
        }
    }

    private static void Read(ContactPointLanes* point, int lane, out PointMemory memory)
    {
        memory.Id = point->Id[lane];
        memory.Normal = point->Normal[lane];
        memory.Tangent = point->Tangent[lane];
        memory.PreviousNormal = point->PreviousNormal[lane];
        memory.PreviousTangent = point->PreviousTangent[lane];
        memory.Feed = point->Feed[lane];
    }

    private static PointMemory Match(uint id, in PointMemory first, in PointMemory second)
    {
        if (first.Id == id)
        {
            return first;
        }

        return second.Id == id ? second : default;
    }

    private static void WritePoint(
        ContactPointLanes* point, int lane, in ManifoldPoint source, Vector2 normal, Vector2 offset, float rest, in PointMemory old, float scale)
    {
        Vector2 rA = source.Anchor;
        Vector2 rB = source.Anchor - offset;
        float anA = (rA.X * normal.X) + (rA.Y * normal.Y);
        float anB = (rB.X * normal.X) + (rB.Y * normal.Y);
        point->NormalArmA[lane] = anA;
        point->NormalArmB[lane] = anB;
        point->TangentArmA[lane] = (rA.X * normal.Y) - (rA.Y * normal.X);
        point->TangentArmB[lane] = (rB.X * normal.Y) - (rB.Y * normal.X);
        point->Base[lane] = (source.Separation + rest) - (anB - anA);
        point->Normal[lane] = old.Normal * scale;
        point->Tangent[lane] = old.Tangent * scale;
        point->PreviousNormal[lane] = old.PreviousNormal * scale;
        point->PreviousTangent[lane] = old.PreviousTangent * scale;
        point->Feed[lane] = old.Feed * scale;
        point->Bounce[lane] = 0;
        point->Id[lane] = source.Id;
    }

    private static void ClearPoint(ContactPointLanes* point, int lane)
    {
        point->NormalArmA[lane] = 0;
        point->NormalArmB[lane] = 0;
        point->TangentArmA[lane] = 0;
        point->TangentArmB[lane] = 0;
        point->Base[lane] = ContactBundle.NoPoint;
        point->Normal[lane] = 0;
        point->Tangent[lane] = 0;
        point->PreviousNormal[lane] = 0;
        point->PreviousTangent[lane] = 0;
        point->Feed[lane] = 0;
        point->Bounce[lane] = 0;
        point->Id[lane] = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Square(float x) => x * x;
}
