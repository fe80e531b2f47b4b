using System.Runtime.CompilerServices;

namespace Farseer.Engine.Contacts;

/// <summary>Names, empties and moves single lanes of the bundles of rows.</summary>
internal static unsafe class ContactLanes
{
    private const int EmptyMarks = ContactBundle.SingleMark | ContactBundle.BlockMark;

    /// <summary>Makes a lane inert: no contact, or one that gives no impulse in this step.</summary>
    public static void Mute(ContactBundle* row, int lane)
    {
        ClearPoint(&row->Point0, lane);
        ClearPoint(&row->Point1, lane);
        row->Id0[lane] = 0;
        row->Id1[lane] = 0;
    }

    /// <summary>Scales the impulses of a lane to those of another substep.</summary>
    public static void Scale(ContactBundle* row, int lane, float factor)
    {
        ScalePoint(&row->Point0, lane, factor);
        ScalePoint(&row->Point1, lane, factor);
    }

    /// <summary>Writes down which pair a lane holds.</summary>
    public static void Name(ContactBundle* row, int lane, int contact, in ContactRecord record)
    {
        row->BodyA[lane] = record.BodyA;
        row->BodyB[lane] = record.BodyB;
        row->PieceA[lane] = record.PieceA;
        row->PieceB[lane] = record.PieceB;
        row->Contact[lane] = contact;
        SetFlags(row, lane, record.Flags);
    }

    /// <summary>The flags of the record have changed.</summary>
    public static void SetFlags(ContactBundle* row, int lane, ContactFlags flags) =>
        row->Flags[lane] = (row->Flags[lane] & ~ContactBundle.FlagBits) | (int)flags;

    /// <summary>A lane that holds no pair.</summary>
    public static void Unname(ContactBundle* row, int lane)
    {
        row->BodyA[lane] = 0;
        row->BodyB[lane] = 0;
        row->PieceA[lane] = ContactSides.NoPiece;
        row->PieceB[lane] = ContactSides.NoPiece;
        row->Contact[lane] = -1;
        row->Flags[lane] = EmptyMarks;
    }

    /// <summary>A bundle without pairs, the first of a record in which there is no other, to be named and then written.</summary>
    public static void ClearForWrite(ContactBundle* row)
    {
        Unsafe.InitBlock(row, 0, ContactBundle.Bytes);
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            Unname(row, lane);
        }
    }

    /// <summary>
    /// Empties all lanes of all bundles of a record. Those that a colour has no rows for yet may be solved with the others.
    /// </summary>
    /// <param name="first">The first of its bundles.</param>
    public static void ClearRecord(ContactBundle* first)
    {
        for (int lane = 0; lane < ContactBundle.LineLanes; lane++)
        {
            ClearLane(first, lane);
        }
    }

    /// <summary>An empty lane: bodies 0 (the dummy), no mass, unit responses so that nothing divides by zero.</summary>
    public static void ClearLane(ContactBundle* row, int lane)
    {
        Unname(row, lane);
        Rest(row, lane);
        row->Struck[lane] = 0;
        row->Slot[lane] = 0;
        Mute(row, lane);
    }

    /// <summary>The marks of lanes without a contact are those of an empty lane again, in all bundles of a record.</summary>
    /// <param name="first">The first of its bundles.</param>
    public static void RestMarks(ContactBundle* first)
    {
        for (int lane = 0; lane < ContactBundle.LineLanes; lane++)
        {
            if (first->Contact[lane] < 0)
            {
                first->Flags[lane] = EmptyMarks;
            }
        }
    }

    /// <summary>All that the narrow phase writes into a row, as it is where there is no contact.</summary>
    public static void Rest(ContactBundle* row, int lane)
    {
        row->NormalX[lane] = 0;
        row->NormalY[lane] = 0;
        row->Friction[lane] = 0;
        row->MassA[lane] = 0;
        row->InertiaA[lane] = 0;
        row->MassB[lane] = 0;
        row->InertiaB[lane] = 0;
        row->RadiusA[lane] = 0;
        row->RadiusB[lane] = 0;
        row->K11[lane] = 1;
        row->K22[lane] = 1;
        row->FeedRate[lane] = 0;
        row->FeedShare[lane] = 0;
        row->Restitution[lane] = 0;
        ClearArms(&row->Point0, lane);
        ClearArms(&row->Point1, lane);
    }

    /// <summary>Notes impacts that were not the solver's: the row holds no impulse that would act on.</summary>
    public static void NoteImpacts(ContactBundle* row, int lane, float normal)
    {
        ScalePoint(&row->Point0, lane, 0);
        ScalePoint(&row->Point1, lane, 0);
        row->Struck[lane] = normal;
    }

    /// <summary>Fields of a lane.</summary>
    private static int Columns => ContactBundle.Bytes / (sizeof(int) * ContactBundle.LineLanes);

    /// <summary>Moves a contact from one lane to another; every field is a column of four bytes a lane, one to a line.</summary>
    public static void MoveLane(ContactBundle* source, int sourceLane, ContactBundle* target, int targetLane)
    {
        int* from = (int*)source + sourceLane;
        int* to = (int*)target + targetLane;
        for (int i = 0; i < Columns; i++)
        {
            to[i * ContactBundle.LineLanes] = from[i * ContactBundle.LineLanes];
        }
    }

    /// <summary>Lets two contacts change their lanes.</summary>
    public static void ExchangeLanes(ContactBundle* one, int laneOfOne, ContactBundle* other, int laneOfOther)
    {
        int* first = (int*)one + laneOfOne;
        int* second = (int*)other + laneOfOther;
        for (int i = 0; i < Columns; i++)
        {
            int at = i * ContactBundle.LineLanes;
            (first[at], second[at]) = (second[at], first[at]);
        }
    }

    private static void ScalePoint(ContactPointLanes* point, int lane, float factor)
    {
        point->Normal[lane] *= factor;
        point->Tangent[lane] *= factor;
        point->PreviousNormal[lane] *= factor;
        point->PreviousTangent[lane] *= factor;
        point->Feed[lane] *= factor;
    }

    private static void ClearPoint(ContactPointLanes* point, int lane)
    {
        ClearArms(point, lane);
        point->Normal[lane] = 0;
        point->Tangent[lane] = 0;
        point->PreviousNormal[lane] = 0;
        point->PreviousTangent[lane] = 0;
        point->Feed[lane] = 0;
    }

    private static void ClearArms(ContactPointLanes* point, int lane)
    {
        point->NormalArmA[lane] = 0;
        point->NormalArmB[lane] = 0;
        point->TangentArmA[lane] = 0;
        point->TangentArmB[lane] = 0;
        point->Base[lane] = ContactBundle.NoPoint;
    }
}
